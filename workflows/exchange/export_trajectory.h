// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "workflows/exchange/motion_rows.h"

namespace gaitwright {

/// The rows as a message trajectory_msgs/JointTrajectory of ROS 2, in YAML for `ros2 topic pub`: `header`,
/// `joint_names`, and `points` with `positions`, `velocities`, `accelerations` and `effort` of all independent joints
/// [rad, rad/s, rad/s^2, N m; m and N for prismatic joints] and `time_from_start` from the first row. Missing data give
/// empty lists, as the message format requires. The base's motion is left out, because the message cannot contain it.
/// @throws InvalidArgument that names the joint and the time of a value that is not finite.
std::string JointTrajectoryYaml(const RobotModel& model, const MotionRows& rows);

/// The message of JointTrajectoryYaml as JSON, with the same keys.
std::string JointTrajectoryJson(const RobotModel& model, const MotionRows& rows);

}  // namespace gaitwright
