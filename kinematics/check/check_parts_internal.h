// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// Mass, inertia and size of each body against each other.
void CheckBodies(const RobotModel& model, std::vector<Finding>& findings);

/// Ranges of joints of so many turns that they may be in degrees.
void CheckRanges(const RobotModel& model, std::vector<Finding>& findings);

/// Torque and speed of each joint against what motors have.
void CheckMotors(const RobotModel& model, std::vector<Finding>& findings);

/// The torque that gravity asks of each joint as the robot stands, on all its feet and on half of them, against what
/// the joint can give.
void CheckHolding(const RobotModel& model, std::vector<Finding>& findings);
/// Whether two numbers that ought to be one differ by more than 1 %; infinite ones are alike.
bool NumbersDiffer(double a, double b);

}  // namespace gaitwright
