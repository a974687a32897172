// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/model/robot_model.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// Margin of a plan to both ends of a joint's range, if possible, as a share of the range.
inline constexpr double kRangeMargin = 0.01;

/// Excess of joints and motors (Actuator) beyond their limits, summed in shares of the limits: 0 if all limits are
/// kept.
/// @param spare  margin to both ends of a joint's range, as a share of the range, that counts as limit except in the
/// standing posture.
double TotalExcess(const RobotModel& model, const WholeBodyTrajectory& motion, double spare);

/// Limits of joints and motors that the trajectory violates, the worst of each joint or motor and kind.
std::vector<std::string> LimitWarnings(const RobotModel& model, const WholeBodyTrajectory& motion);

}  // namespace gaitwright
