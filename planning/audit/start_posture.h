// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "kinematics/base/result.h"
#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// Measured joint positions of a robot before its first command.
struct StartPosture {
  VectorX joints;                  ///< positions of the independent joints [rad], [m]
  std::optional<Quaternion> R_WB;  ///< orientation of the base, if measured by an IMU; its heading is ignored
};

/// Largest accepted position of a joint without limits [rad], [m].
inline constexpr double kFarthestMeasured = 1000.0;

/// Reads a start posture from the text of a YAML file: the position of each independent joint by name, in rad
/// (prismatic joints in m), at the top level or under `joints`; optionally `base_quaternion_xyzw: [x, y, z, w]`.
///
///     FR_hip_joint: 0.02
///     FR_thigh_joint: 0.81
///     ...
///     base_quaternion_xyzw: [0.0, 0.01, 0.0, 0.99995]
///
/// Refuses, with the line: an unknown joint (the message names the nearest one), a joint that follows another one, a
/// duplicate, a missing joint, a position outside of the joint's limits (with a hint if all positions are probably in
/// degrees), a position beyond kFarthestMeasured of a joint without limits, and a quaternion whose length is not 1 to
/// 1e-3.
/// @param source  name of the text in messages.
Result<StartPosture> StartPostureFromYaml(const std::string& text, const std::string& source, const RobotModel& model);

/// Reads the start posture of a file.
Result<StartPosture> LoadStartPosture(const std::string& path, const RobotModel& model);

}  // namespace gaitwright
