// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "workflows/exchange/motion_rows.h"

namespace gaitwright {

/// The rows as a message trajectory_msgs/JointTrajectory of ROS 2, as YAML (what `ros2 topic pub` takes): `header`,
/// `joint_names`, and `points` with `positions`, `velocities`, `accelerations` and `effort` of all independent joints
/// [rad, rad/s, rad/s^2, N m; m and N for one that slides] and `time_from_start` from the first row. Lists that the
/// rows lack are empty, as the message has it. The base's motion is left out: the message has none.
/// @throws InvalidArgument naming the joint and the time of a figure that is not finite.
std::string JointTrajectoryYaml(const RobotModel& model, const MotionRows& rows);

/// The same message as JSON, with the same keys.
std::string JointTrajectoryJson(const RobotModel& model, const MotionRows& rows);

}  // namespace gaitwright
