// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <vector>

#include "kinematics/ik/leg_polytope.h"
#include "kinematics/model/robot_model.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// Pose X_WB of the base at a time; an empty function if unknown.
using BaseMotion = std::function<Pose(double time_s)>;

/// Offset of a sphere's contact point from its swing curve due to rolling in the air:
///   off(u) = rolled(u) - SmoothStep(u, cruise) rolled(1),
/// because the path is the curve plus the roll since lift-off, and the curve ends short by the total roll.
class SwingRoll {
 public:
  SwingRoll() = default;  ///< for a foot that does not roll, or whose roll is unknown: zero
  /// @param off_W  at uniform fractions of the swing from 0 to 1 [m]; two or more, or empty.
  explicit SwingRoll(std::vector<Vector3> off_W) : off_W_(std::move(off_W)) {}

  /// Offset at a fraction of the swing, clamped to [0, 1]; linear between samples.
  Vector3 At(double u) const;

 private:
  std::vector<Vector3> off_W_;
};

/// A half-space of W that holds a foot's contact frame: the points p with normal_W . p <= offset_m.
struct ReachSide {
  Vector3 normal_W = Vector3::UnitX();
  double offset_m = 0.0;
};

/// The sides of a workspace in W, for a body frame at p_W with rotation R_WB, moved outward by `beyond_m`.
std::vector<ReachSide> SidesInWorld(const std::vector<WorkspaceSide>& workspace_B, const Vector3& p_W,
                                    const Matrix3& R_WB, double beyond_m);

/// Known motion of the whole body before swings are planned, from a previous pass.
struct FormerMotion {
  BaseMotion base;
  std::function<SwingRoll(const SwingTrajectory& swing)> roll;      ///< empty if unknown
  std::vector<SwingTrajectory> swings = {};                         ///< whose detours are reused if possible
  std::function<double(const SwingTrajectory& swing)> lift_m = {};  ///< of a swing; empty for the default
  std::function<double(const SwingTrajectory& swing)> cruise = {};  ///< of a swing; empty for none
  /// Convex reach of a foot at a time; empty if it follows from `base`, or is left to the audit.
  std::function<std::vector<ReachSide>(int foot, double time_s)> reach = {};
};

/// The motion of a pass; it keeps no reference to the trajectory.
FormerMotion MotionOf(const RobotModel& model, const WholeBodyTrajectory& trajectory,
                      const std::vector<SwingTrajectory>& swings = {});

}  // namespace gaitwright
