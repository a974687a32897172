// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "kinematics/base/result.h"
#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// Where a robot's joints are before it is sent its first command, as measured.
struct StartPosture {
  VectorX joints;                  ///< of the independent joints [rad], [m]
  std::optional<Quaternion> R_WB;  ///< of the base, if an IMU measured it; its heading is ignored
};

/// How far from zero a joint without limits may be measured, some hundred turns [rad], [m].
inline constexpr double kFarthestMeasured = 1000.0;

/// A start posture from the text of a YAML file: each independent joint by name with its position in rad (a sliding one
/// in m), at the top or under `joints`, and if wished `base_quaternion_xyzw: [x, y, z, w]`.
///
///     FR_hip_joint: 0.02
///     FR_thigh_joint: 0.81
///     ...
///     base_quaternion_xyzw: [0.0, 0.01, 0.0, 0.99995]
///
/// Refused, with the line: a joint that the robot does not have (the nearest is named), that follows another or is
/// named twice, one that is missing, a position outside of its joint's limits (and whether all are likely in degrees),
/// or beyond kFarthestMeasured where it has none, and a quaternion whose length is not 1 to 1e-3.
/// @param source  names the text in messages.
Result<StartPosture> StartPostureFromYaml(const std::string& text, const std::string& source, const RobotModel& model);

/// The start posture of a file.
Result<StartPosture> LoadStartPosture(const std::string& path, const RobotModel& model);

}  // namespace gaitwright
