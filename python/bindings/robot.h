// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>

#include "kinematics/model/robot_model.h"

namespace gaitwright::python {

/// A robot never changes, so all users share it.
using SharedRobot = std::shared_ptr<RobotModel>;

/// Index of the foot with this name. @throws InvalidArgument if there is none; the message names the nearest.
int FootIndex(const RobotModel& model, const std::string& name);

}  // namespace gaitwright::python
