// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// Compares mass, inertia and size of each body.
void CheckBodies(const RobotModel& model, std::vector<Finding>& findings);

/// Finds ranges of joints of several turns, which may be in degrees.
void CheckRanges(const RobotModel& model, std::vector<Finding>& findings);

/// Compares torque and speed limits of each joint with those of typical motors.
void CheckMotors(const RobotModel& model, std::vector<Finding>& findings);

/// Compares the torque of each joint that holds the standing robot, on all its feet and on half of them, with the limit
/// of the joint.
void CheckHolding(const RobotModel& model, std::vector<Finding>& findings);
/// Whether two numbers that should be equal differ by more than 1 %; two infinite numbers are equal.
bool NumbersDiffer(double a, double b);

}  // namespace gaitwright
