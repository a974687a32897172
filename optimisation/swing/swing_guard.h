// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "kinematics/collision/shape_scene.h"
#include "kinematics/dynamics/dynamics.h"
#include "kinematics/ik/leg_ik.h"
#include "planning/audit/ground_watch.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// Where the base is at a time, X_WB; a function that is empty where that is not known.
using BaseMotion = std::function<Pose(double time_s)>;

/// What a swing comes too near to.
struct SwingHit {
  double at_s = 0.0;
  std::string part;         ///< link of the robot
  std::string solid;        ///< of the terrain
  double distance_m = 0.0;  ///< negative when they overlap
  double asked_m = 0.0;
};

/// Holds whole feet along their swings, and where the base's motion is given the legs above them, against all solids
/// of a terrain.
class SwingGuard {
 public:
  SwingGuard(const RobotModel& model, const Terrain& terrain, BaseMotion base);

  /// The first place of a swing at which the foot comes nearer to a solid than `clearance_m` times ClearanceRamp, or a
  /// part of the leg touches one. Beside a riser less is asked for: no more than the foot has there when it is lifted
  /// straight up from its footholds by the clearance.
  std::optional<SwingHit> Check(const SwingTrajectory& swing, double clearance_m) const;

 private:
  struct LegPart {
    PreparedShape shape;
    int body;
  };
  double AskedAtMost(const SwingTrajectory& swing, double clearance_m) const;
  std::optional<SwingHit> CheckLeg(const SwingTrajectory& swing) const;
  std::optional<SwingHit> CheckLegAt(int foot, double time_s) const;

  const RobotModel& model_;
  GroundWatch watch_;
  BaseMotion base_;
  std::vector<LegIk> ik_;                    // by foot, where the base's motion is known
  std::vector<std::vector<LegPart>> parts_;  // by foot: the leg's shapes that are not the foot's
  mutable DynamicsScratch scratch_;
};

}  // namespace gaitwright
