// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// Finds implausible data of a loaded robot: inertia that does not fit mass and size; differences between left and
/// right; mass without shape and shape without mass; torque and speed limits that no motor has; joints too weak to hold
/// the robot; parts below the ground or inside each other in the standing posture. Findings of the model come first.
std::vector<Finding> CheckRobot(const RobotModel& model);

}  // namespace gaitwright
