// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// A constant planar twist of the base, in the base's frame, per unit of progress. The goal is at progress 1.
struct PlanarTwist {
  double x_m = 0.0, y_m = 0.0, yaw_rad = 0.0;
};

/// exp of a planar twist times `progress`: the pose reached from the origin. Lynch and Park, Modern Robotics, 2017,
/// 3.2.3.
PlanarPose PoseAlong(const PlanarTwist& twist, double progress);

/// The twist that reaches the pose at progress 1 (yaw in (-pi, pi)).
PlanarTwist TwistTo(const PlanarPose& pose);

/// Progress in [0, 1] at a time: smooth start and stop over `ramp_s` each, constant rate in between.
double ProgressAt(double time_s, double duration_s, double ramp_s);

/// As above, with different start and stop times; both are shortened by the same factor if they do not fit.
double ProgressAt(double time_s, double duration_s, double start_ramp_s, double stop_ramp_s);

/// The base path that follows the twist from start_s for duration_s, sampled every 10 ms until end_s.
BasePath MakeBasePath(const PlanarTwist& twist, double start_s, double duration_s, double ramp_s, double end_s);

/// A part of a path: a twist from a pose, with start time and duration.
struct PathPiece {
  PlanarTwist twist;
  double start_s = 0.0, duration_s = 0.0;
  double start_ramp_s = 0.0, stop_ramp_s = 0.0;  ///< duration of its acceleration and deceleration
};

/// The base path along consecutive pieces, sampled every 10 ms until end_s. A piece that starts during the stop ramp of
/// the piece before is blended with it: if both ramps coincide, equal speeds stay constant.
BasePath MakeBasePath(const std::vector<PathPiece>& pieces, double end_s);

/// A pose given in the frame of `from`, as a pose in W.
PlanarPose Carried(const PlanarPose& from, const PlanarPose& pose);

/// The pose at a time, with linear interpolation between samples; clamped at the ends.
PlanarPose PoseAt(const BasePath& path, double time_s);

}  // namespace gaitwright
