// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// Where two descriptions of one robot differ. Joints go by their names: places and axes at joint positions zero,
/// limits, and of the body that each carries mass, centre of mass and inertia. Where the root links have their origins
/// in other places, all is compared as if they had not. @param b  the other one.
std::vector<Finding> CompareRobots(const RobotModel& a, const RobotModel& b);

}  // namespace gaitwright
