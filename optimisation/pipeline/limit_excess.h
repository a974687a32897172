// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/model/robot_model.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// How far the joints are past their limits, summed in shares of the limits: 0 where all are kept.
double TotalExcess(const RobotModel& model, const WholeBodyTrajectory& motion);

/// Joint limits that the trajectory does not keep, worst of each joint and kind.
std::vector<std::string> LimitWarnings(const RobotModel& model, const WholeBodyTrajectory& motion);

}  // namespace gaitwright
