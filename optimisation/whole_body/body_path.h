// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/trajectory/cubic_spline.h"
#include "optimisation/numerics/smooth_within.h"
#include "planning/footsteps/plan_footsteps.h"

namespace gaitwright {

/// How the base is turned at a time, with its exact derivatives.
struct BaseTurning {
  Matrix3 R_WB = Matrix3::Identity();  ///< from the attitude of standing on level ground
  Vector3 w_WB = Vector3::Zero(), alpha_WB = Vector3::Zero();
};

/// The same of angles that change: R = Rz(yaw) Ry(pitch) Rx(roll).
BaseTurning TurningOf(const Motion1& yaw, const Motion1& pitch, const Motion1& roll);

/// The base's turning, and the height of the ground that it is carried over, through a walk: it follows the plane
/// through the feet (FitBase), those in the air taken between their footholds, evened out over a while.
class BodyPath {
 public:
  /// @param even_s  time over which height and tilt are evened out [s]; a cycle of the gait.
  BodyPath(const RobotModel& model, const FootstepSkeleton& skeleton, double even_s);

  /// Attitude, and its first two derivatives in W.
  BaseTurning TurningAt(double time_s) const;
  /// Height of the ground under the base [m], and its derivatives.
  Motion1 GroundAt(double time_s) const { return ground_.At(time_s); }
  double YawAt(double time_s) const { return yaw_.At(time_s).value; }

  /// Carries the base higher or lower than over its feet, no more than is asked for and without sharp bends.
  /// @param ground_m  by knot: bounds on what GroundAt gives [m].
  /// @param bend_s    time over which bends are spread.
  void KeepWithin(const std::vector<Bounds>& ground_m, double bend_s);
  /// Leans the body forward by an angle [rad] once it walks, and upright again at the end, over `bend_s` each.
  void Lean(double angle_rad, double bend_s);
  /// Knots between which all goes smoothly.
  int knots() const { return static_cast<int>(ground_m_.size()); }
  /// Time of one [s].
  double KnotTime(int knot) const { return start_s_ + knot * step_s_; }

 private:
  double start_s_, step_s_;
  std::vector<double> pitch_rad_;               // by knot
  std::vector<double> over_feet_m_, ground_m_;  // by knot; without and with what was asked for
  CubicSpline yaw_, pitch_, roll_, ground_;
};

}  // namespace gaitwright
