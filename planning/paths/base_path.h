// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// A constant twist of the base in the plane for a unit of progress, in the base's frame: progress 1 ends at the goal.
struct PlanarTwist {
  double x_m = 0.0, y_m = 0.0, yaw_rad = 0.0;
};

/// exp of a planar twist times `progress`: the pose reached from the origin. Lynch and Park, Modern Robotics,
/// 2017, 3.2.3.
PlanarPose PoseAlong(const PlanarTwist& twist, double progress);

/// The twist whose progress 1 is the pose (yaw in (-pi, pi)).
PlanarTwist TwistTo(const PlanarPose& pose);

/// Progress in [0, 1] at a time: smooth start and stop over `ramp_s` each, constant rate between.
double ProgressAt(double time_s, double duration_s, double ramp_s);

/// The same with a stop that takes another time than the start; both shortened alike where they do not fit in.
double ProgressAt(double time_s, double duration_s, double start_ramp_s, double stop_ramp_s);

/// The base path that follows the twist from start_s for duration_s, sampled every 10 ms until end_s.
BasePath MakeBasePath(const PlanarTwist& twist, double start_s, double duration_s, double ramp_s, double end_s);

/// A twist from one pose on, in a time of its own: part of a path.
struct PathPiece {
  PlanarTwist twist;
  double start_s = 0.0, duration_s = 0.0;
  double start_ramp_s = 0.0, stop_ramp_s = 0.0;  ///< in which its speed is gained and lost
};

/// The base path along pieces one after the other, each of which starts from where the one before leads, sampled every
/// 10 ms until end_s. One that starts when the one before is slowing down takes over from it: where both ramps are
/// one, speeds that are alike stay as they are.
BasePath MakeBasePath(const std::vector<PathPiece>& pieces, double end_s);

/// A pose given from another one, in W.
PlanarPose Carried(const PlanarPose& from, const PlanarPose& pose);

/// The pose at a time, linearly between samples and clamped at the ends.
PlanarPose PoseAt(const BasePath& path, double time_s);

}  // namespace gaitwright
