// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/model/robot_model.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// Margin of a plan to both ends of a joint's range, if possible, as a share of the range.
inline constexpr double kRangeMargin = 0.01;

/// How far joints and motors (Actuator) are past their limits, summed in shares of the limits: 0 where all are kept.
/// @param spare  share of a joint's range, nearer than which to either end counts as past it, other than to stand.
double TotalExcess(const RobotModel& model, const WholeBodyTrajectory& motion, double spare);

/// Limits of joints and motors that the trajectory does not keep, worst of each joint or motor and kind.
std::vector<std::string> LimitWarnings(const RobotModel& model, const WholeBodyTrajectory& motion);

}  // namespace gaitwright
