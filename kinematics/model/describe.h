// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// Text that describes a robot and the derived data with their sources.
std::string DescribeRobot(const RobotModel& model);

/// The description as a JSON object: name, mass, legs with their feet and soles (corners in the sole frame), mirror
/// pairs, standing posture, limits and gains by joint (null: no limit, or a derived gain), notes. Keys contain the
/// units.
std::string RobotJson(const RobotModel& model);

}  // namespace gaitwright
