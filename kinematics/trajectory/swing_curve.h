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

/// Bump 64 u^3 (1 - u)^3: from 0 to 1 at u = 1/2 and back to 0, with zero rate and acceleration at both ends; 0
/// outside.
Motion1 SmoothBump(double u);

/// Motion of a foot's contact frame in W.
struct FrameMotion {
  Pose X_WF = Pose::Identity();
  Vector3 v_WF = Vector3::Zero(), w_WF = Vector3::Zero();
  Vector3 a_WF = Vector3::Zero(), alpha_WF = Vector3::Zero();
};

/// Number of zero control points at each end of a swing's detour, so that the swing starts and ends at rest.
inline constexpr int kFixedSwingPoints = 3;

/// A swing from start to end, at rest (zero velocity and acceleration) at both ends. The move is a minimum-jerk move,
/// or one with constant speed in the middle (`cruise`); see SmoothStep. A bump of `lift_m` along z is added; with
/// `cruise`, it is a parabola like that of a body in flight. The rotation is the shortest one, about a fixed axis. If
/// `detour_W` has control points, a quintic B-spline replaces the bump, with three zero control points before and after
/// them.
struct SwingCurve {
  double start_s = 0.0, end_s = 1.0;
  Pose X_WF_start = Pose::Identity(), X_WF_end = Pose::Identity();
  double lift_m = 0.0;
  std::vector<Vector3> detour_W = {};  ///< [m]
  double cruise = 0.0;                 ///< share of the time at constant speed, below 1
};

/// The motion of the frame at a time; outside [start_s, end_s], at rest at the nearer end.
FrameMotion Evaluate(const SwingCurve& curve, double time_s);

/// The curve without its bump or detour: the minimum-jerk move between the same ends over the same time.
SwingCurve StraightMoveOf(SwingCurve curve);

/// Height of the frame's origin above the straight line between its ends, at half time [m].
double LiftAtHalfTime(const SwingCurve& curve);

}  // namespace gaitwright
