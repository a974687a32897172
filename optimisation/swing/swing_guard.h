// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "kinematics/collision/shape_scene.h"
#include "kinematics/dynamics/dynamics.h"
#include "kinematics/ik/leg_ik.h"
#include "optimisation/swing/former_motion.h"
#include "planning/audit/ground_watch.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// What a swing comes too near to.
struct SwingHit {
  double at_s = 0.0;
  std::string part;         ///< link of the robot
  std::string solid;        ///< of the terrain
  double distance_m = 0.0;  ///< negative when they overlap
  double asked_m = 0.0;
};

/// Holds whole feet along their swings, and where the base's motion is given the legs above them, against all solids
/// of a terrain. Feet are where they go: on their curves, and off them by what they roll where that is known.
class SwingGuard {
 public:
  SwingGuard(const RobotModel& model, const Terrain& terrain, FormerMotion former);

  /// The first place of a swing at which the foot comes nearer to a solid than `clearance_m` times ClearanceRamp, or a
  /// part of the leg touches one. Beside a riser less is asked for: no more than the foot has there when it is lifted
  /// straight up from its footholds by the clearance. Near both ends it may touch the ground as deep as half of what
  /// SwingDepth lets pass, or as it stands there.
  std::optional<SwingHit> Check(const SwingTrajectory& swing, double clearance_m, bool with_leg = true) const;

  /// Whether the leg can follow the swing within its joints' limits of position and speed; true where the base's motion
  /// is not known.
  bool LegFollows(const SwingTrajectory& swing) const;

  /// Whether nothing touches the leg where the swing starts and ends; if not, no way between them helps.
  bool LegHasRoom(const SwingTrajectory& swing) const { return !former_.base || !CheckLeg(swing, kSamples); }

  /// What a sphere rolls off the swing's curve.
  SwingRoll RollOf(const SwingTrajectory& swing) const { return former_.roll ? former_.roll(swing) : SwingRoll(); }

 private:
  static constexpr int kSamples = 60;

  struct LegPart {
    PreparedShape shape;
    int body;
  };
  static double TimeOf(const SwingTrajectory& swing, int sample) {
    return swing.start_s + (swing.end_s - swing.start_s) * sample / kSamples;
  }
  std::vector<Pose> FootPoses(const SwingTrajectory& swing) const;
  double AskedAtMost(const SwingTrajectory& swing, double clearance_m) const;
  VectorX StandingLeg(int foot) const;
  std::optional<SwingHit> CheckLeg(const SwingTrajectory& swing, int stride) const;
  std::optional<SwingHit> CheckLegAt(int foot, double time_s) const;

  const RobotModel& model_;
  GroundWatch watch_;
  FormerMotion former_;
  std::vector<LegIk> ik_;                    // by foot, where the base's motion is known
  std::vector<std::vector<LegPart>> parts_;  // by foot: the leg's shapes that are not the foot's
  mutable DynamicsScratch scratch_;
};

}  // namespace gaitwright
