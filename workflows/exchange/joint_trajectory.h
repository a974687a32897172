// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>

#include "kinematics/base/result.h"
#include "workflows/exchange/compared_motion.h"
#include "workflows/exchange/motion_table.h"

namespace gaitwright {

/// The largest joint trajectory in YAML [byte], and the most values: three times what is read of other YAML, since it
/// is nothing but numbers. In JSON it has the bounds of plans and logs.
inline constexpr std::size_t kLargestTrajectoryYaml = std::size_t{48} << 20, kMostTrajectoryYamlValues = 3'000'000;

/// A trajectory_msgs/JointTrajectory of ROS in YAML, as `rostopic echo`, `ros2 topic echo` or a file has it:
///   joint_names: [...]
///   points: [{positions: [...], velocities: [...], effort: [...], time_from_start: {sec: 0, nanosec: 5000000}}, ...]
/// also with secs and nsecs, with a number in the unit of times, and within `trajectory:`. Velocities and efforts may
/// be left out or empty, in all points alike; accelerations are not used. Joints that the robot does not have are
/// refused with the nearest; those it has and the file lacks as `missing_joints` says. It has no base and no contacts.
/// Failure kBadInput `joint_trajectory` naming the line.
/// @param source  names it in messages.  @param some_joints  whatever the options say, the positions of joints that the
/// file lacks are not a number.
Result<MotionTable> ParseJointTrajectory(const RobotModel& model, const std::string& text, const std::string& source,
                                         const ImportOptions& options, bool some_joints = false);

/// The same in JSON; failures name the way to the value.
Result<MotionTable> ParseJointTrajectoryJson(const RobotModel& model, const std::string& text,
                                             const std::string& source, const ImportOptions& options,
                                             bool some_joints = false);

/// Either of them, JSON by its first character, as one side of a comparison, with the joints that there are. Failures
/// of the above and of CheckedTable.
Result<ComparedMotion> ComparedTrajectory(const RobotModel& model, const std::string& text, const std::string& source,
                                          const ImportOptions& options);

}  // namespace gaitwright
