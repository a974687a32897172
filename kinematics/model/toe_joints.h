// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// Joints of toes: the last joint of a limb of six or more, where the body before it has a flat bottom that is on one
/// level with that of the body beyond it, within 3 mm at joint positions zero, and no smaller. A foot of two links is
/// planned as one sole. Joints that follow others, or that others follow, are none.
std::vector<std::string> ToeJoints(const RobotModel& model);

/// A URDF with joints of these names made fixed.
std::string WithFixedJoints(const std::string& urdf_text, const std::vector<std::string>& joints);

}  // namespace gaitwright
