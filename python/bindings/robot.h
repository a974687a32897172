// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>

#include "kinematics/model/robot_model.h"

namespace gaitwright::python {

/// Robots are never changed: whatever needs one shares it.
using SharedRobot = std::shared_ptr<RobotModel>;

/// Index of the foot of that name. @throws InvalidArgument naming the nearest.
int FootIndex(const RobotModel& model, const std::string& name);

}  // namespace gaitwright::python
