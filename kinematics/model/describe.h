// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// What a robot is and what was derived from what, for people.
std::string DescribeRobot(const RobotModel& model);

/// The same as a JSON object: name, mass_kg, dofs, legs, feet, standing, limits, notes.
std::string RobotJson(const RobotModel& model);

}  // namespace gaitwright
