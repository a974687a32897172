// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/spatial/pose.h"

namespace gaitwright {

/// Position, velocity and acceleration of a scalar at one time.
struct Motion1 {
  double value = 0.0, rate = 0.0, acceleration = 0.0;
};

/// Minimum-jerk step from 0 to 1 over u in [0, 1] and its derivatives by u: 10 u^3 - 15 u^4 + 6 u^5; constant outside.
/// Flash and Hogan, J. Neuroscience 5(7), 1985. With `cruise` above 0 (below 1), this share of the time in the middle
/// has constant rate, with the two halves of the minimum-jerk step before and after.
Motion1 SmoothStep(double u, double cruise = 0.0);

/// Bump 64 u^3 (1 - u)^3 from 0 to 1 at u = 1/2 and back, with zero rate and acceleration at both ends; 0 outside.
Motion1 SmoothBump(double u);

/// Motion of a foot's contact frame in W.
struct FrameMotion {
  Pose X_WF = Pose::Identity();
  Vector3 v_WF = Vector3::Zero(), w_WF = Vector3::Zero();
  Vector3 a_WF = Vector3::Zero(), alpha_WF = Vector3::Zero();
};

/// Control points at each end of a swing's detour, which are zero: it starts and ends at rest on its footholds.
inline constexpr int kFixedSwingPoints = 3;

/// A swing: a minimum-jerk move, or one with constant speed in the middle (`cruise`), from start to end (SmoothStep),
/// with a bump of `lift_m` along z, which is a parabola with `cruise`, as of a body in flight; at rest (zero velocity
/// and acceleration) at both ends. The rotation is the shortest one, about a fixed axis. If `detour_W` has control
/// points, a quintic B-spline replaces the bump: three points of zero, these, three points of zero.
struct SwingCurve {
  double start_s = 0.0, end_s = 1.0;
  Pose X_WF_start = Pose::Identity(), X_WF_end = Pose::Identity();
  double lift_m = 0.0;
  std::vector<Vector3> detour_W = {};  ///< [m]
  double cruise = 0.0;                 ///< share of the time at constant speed, below 1
};

/// The frame's motion at a time; at rest on the ends outside [start_s, end_s].
FrameMotion Evaluate(const SwingCurve& curve, double time_s);

/// Height of the curve's origin above the straight line between its ends, at half time [m].
double LiftAtHalfTime(const SwingCurve& curve);

}  // namespace gaitwright
