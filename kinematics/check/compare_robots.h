// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// Finds differences between two descriptions of one robot. Joints are matched by name. Compared are positions and axes
/// at joint positions zero, limits, and mass, centre of mass and inertia of the body that each joint carries. Different
/// origins of the root links are compensated. @param b  the other description.
std::vector<Finding> CompareRobots(const RobotModel& a, const RobotModel& b);

}  // namespace gaitwright
