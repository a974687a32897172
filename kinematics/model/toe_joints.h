// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// Joints of toes. A toe joint is the last joint of a limb with six or more joints. The bodies before and beyond it
/// have flat bottoms at the same height, within 3 mm at joint positions zero, and the area of the first is at least a
/// quarter of the second. A mimic joint or its leader is not a toe joint. A foot of two links is planned as one sole.
std::vector<std::string> ToeJoints(const RobotModel& model);

/// A URDF with joints of these names made fixed.
std::string WithFixedJoints(const std::string& urdf_text, const std::vector<std::string>& joints);

}  // namespace gaitwright
