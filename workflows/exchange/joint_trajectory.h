// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>

#include "kinematics/base/result.h"
#include "workflows/exchange/compared_motion.h"
#include "workflows/exchange/motion_table.h"

namespace gaitwright {

/// The largest joint trajectory in YAML [byte], and the largest number of values: three times the limit of other YAML,
/// because it contains only numbers. JSON has the limits of plans and logs.
inline constexpr std::size_t kLargestTrajectoryYaml = std::size_t{48} << 20, kMostTrajectoryYamlValues = 3'000'000;

/// Reads a trajectory_msgs/JointTrajectory of ROS in YAML, as printed by `rostopic echo` and `ros2 topic echo`:
///   joint_names: [...]
///   points: [{positions: [...], velocities: [...], effort: [...], time_from_start: {sec: 0, nanosec: 5000000}}, ...]
/// also with secs and nsecs, with a number in the unit of times, and within `trajectory:`. Velocities and efforts may
/// be left out or empty in all points; accelerations are not used. Unknown joints are refused with the nearest name;
/// missing joints are handled by `missing_joints`. The result has no base and no contacts. Failure kBadInput
/// `joint_trajectory`, which names the line.
/// @param source  name in messages. @param some_joints positions of missing joints are NaN, regardless of the options.
Result<MotionTable> ParseJointTrajectory(const RobotModel& model, const std::string& text, const std::string& source,
                                         const ImportOptions& options, bool some_joints = false);

/// As above in JSON; failures name the path to the value.
Result<MotionTable> ParseJointTrajectoryJson(const RobotModel& model, const std::string& text,
                                             const std::string& source, const ImportOptions& options,
                                             bool some_joints = false);

/// Reads YAML or JSON (decided by the first character) as one side of a comparison, with the joints that the file has.
/// Failures: as of the functions above and of CheckedTable.
Result<ComparedMotion> ComparedTrajectory(const RobotModel& model, const std::string& text, const std::string& source,
                                          const ImportOptions& options);

}  // namespace gaitwright
