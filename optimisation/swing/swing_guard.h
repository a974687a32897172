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

/// A solid that a swing comes too close to.
struct SwingHit {
  double at_s = 0.0;
  std::string part;         ///< link of the robot
  std::string solid;        ///< of the terrain
  double distance_m = 0.0;  ///< negative if they overlap
  double asked_m = 0.0;
};

/// Checks whole feet along their swings, and the legs above them if the base's motion is given, against all solids of a
/// terrain. Feet follow their curves, with rolling offsets if known.
class SwingGuard {
 public:
  SwingGuard(const RobotModel& model, const Terrain& terrain, FormerMotion former);

  /// The first point of a swing at which the foot is closer to a solid than `clearance_m` times ClearanceRamp, or a
  /// part of the leg touches one. Beside a riser, less is required: no more than the distance of the foot when it is
  /// lifted straight up from its footholds by the clearance. Near both ends, it may be in the ground by half of
  /// SwingDepth's tolerance, or as deep as at the foothold.
  std::optional<SwingHit> Check(const SwingTrajectory& swing, double clearance_m, bool with_leg = true) const;

  /// Whether the leg can follow the swing within its joints' limits of position and speed; true if the base's motion is
  /// unknown.
  bool LegFollows(const SwingTrajectory& swing) const;

  /// Whether the leg is free of contact at the start and the end of the swing; if not, no path between them helps.
  bool LegHasRoom(const SwingTrajectory& swing) const { return !former_.base || !CheckLeg(swing, kSamples); }

  /// Rolling offset of a sphere from the swing's curve.
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
  std::vector<LegIk> ik_;                    // by foot, if the base's motion is known
  std::vector<std::vector<LegPart>> parts_;  // by foot: the leg's shapes that do not belong to the foot
  mutable DynamicsScratch scratch_;
};

}  // namespace gaitwright
