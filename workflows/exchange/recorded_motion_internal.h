// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/base/result.h"
#include "workflows/exchange/motion_table.h"

namespace gaitwright {

/// Whether a file begins like a recording: MCAP, or a database of SQLite.
bool IsRecording(const std::string& bytes);

/// Whether a path is a folder with a bag of ROS 2, which has a `metadata.yaml`.
bool IsBagFolder(const std::string& path);

/// The files of a bag in the order of its `metadata.yaml`, unpacked. Failure kBadInput `import` for a bag that cannot
/// be read, with the command that converts it.
Result<std::vector<std::string>> ReadBagFolder(const std::string& path);

/// Reads a motion from a recording of ROS 2: joints from sensor_msgs/JointState, or from one
/// trajectory_msgs/JointTrajectory; the base from nav_msgs/Odometry if it has some. Joints are found by name. Rows are
/// at the times of the joint states with the most joints; everything else is interpolated to these times. Times are
/// stamps of the messages if all have one, otherwise the times of recording; they count from the first row.
/// Failure kBadInput `import` with the reason.
/// @param bytes, further  contents of the first file of a recording, and of those after it.
Result<MotionTable> ParseRecordedMotion(const RobotModel& model, const std::string& bytes,
                                        const std::vector<std::string>& further, const std::string& source,
                                        const ImportOptions& options);

}  // namespace gaitwright
