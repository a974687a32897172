// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// What is doubtful about a robot that was loaded, though no law forbids it: numbers that a drawing office would ask
/// about. Inertia against mass and size; left against right; mass without shape and shape without mass; limits of
/// torque and speed that no motor has; joints that are too weak to hold it; parts in the ground or in each other as it
/// stands. The model's own findings come first.
std::vector<Finding> CheckRobot(const RobotModel& model);

}  // namespace gaitwright
