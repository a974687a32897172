// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/base/result.h"
#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// A failure of a rigid body, whose message says "foot 0", with the names of a robot's feet instead.
Failure WithNamesOfFeet(const RobotModel& model, Failure failure);

}  // namespace gaitwright
