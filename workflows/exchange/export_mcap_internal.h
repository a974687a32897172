// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "workflows/exchange/motion_rows.h"

namespace gaitwright {

/// Rows as an MCAP file of ROS 2: a message for each row in /joint_states (sensor_msgs/JointState) and /odom
/// (nav_msgs/Odometry, of the root link in "odom", rates in its axes), and one in /joint_trajectory
/// (trajectory_msgs/JointTrajectory, with accelerations if there are any). Stamps are the times of the rows.
/// @throws InvalidArgument for a value that is not finite, and for a time below 0.
std::string MotionMcap(const RobotModel& model, const MotionRows& rows);

}  // namespace gaitwright
