// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/base/result.h"
#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// Replaces "foot 0" in the message of a rigid body's failure with the name of the robot's foot.
Failure WithNamesOfFeet(const RobotModel& model, Failure failure);

}  // namespace gaitwright
