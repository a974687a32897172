// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/trajectory/cubic_spline.h"
#include "optimisation/numerics/smooth_within.h"
#include "planning/footsteps/plan_footsteps.h"

namespace gaitwright {

/// Rotation of the base at a time, with exact derivatives.
struct BaseTurning {
  Matrix3 R_WB = Matrix3::Identity();  ///< relative to standing on level ground
  Vector3 w_WB = Vector3::Zero(), alpha_WB = Vector3::Zero();
};

/// The rotation R = Rz(yaw) Ry(pitch) Rx(roll) for angles that change with time.
BaseTurning TurningOf(const Motion1& yaw, const Motion1& pitch, const Motion1& roll);

/// The base's rotation and the height of the ground under it during a walk. They follow the plane through the feet
/// (FitBase), with feet in the air between their footholds, and are smoothed over time.
class BodyPath {
 public:
  /// @param even_s  smoothing time of height and tilt [s]; a cycle of the gait.
  BodyPath(const RobotModel& model, const FootstepSkeleton& skeleton, double even_s);

  /// Rotation, and its first two derivatives in W.
  BaseTurning TurningAt(double time_s) const;
  /// Height of the ground under the base [m], and its derivatives.
  Motion1 GroundAt(double time_s) const { return ground_.At(time_s); }
  double YawAt(double time_s) const { return yaw_.At(time_s).value; }

  /// Raises or lowers the base relative to its feet, only as far as the bounds require and without sharp bends.
  /// @param ground_m  by knot: bounds on GroundAt [m].
  /// @param bend_s    time over which bends are spread.
  void KeepWithin(const std::vector<Bounds>& ground_m, double bend_s);
  /// Leans the body forward by an angle [rad] after the start of the walk, and upright again at its end, over `bend_s`
  /// each.
  void Lean(double angle_rad, double bend_s);
  /// Number of knots; the path is smooth in between.
  int knots() const { return static_cast<int>(ground_m_.size()); }
  /// Time of a knot [s].
  double KnotTime(int knot) const { return start_s_ + knot * step_s_; }

 private:
  double start_s_, step_s_;
  std::vector<double> pitch_rad_;               // by knot
  std::vector<double> over_feet_m_, ground_m_;  // by knot; without and with the bounds
  CubicSpline yaw_, pitch_, roll_, ground_;
};

}  // namespace gaitwright
