// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/model/robot_model.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// Margin of a plan to both ends of a joint's range, if possible, as a share of the range.
inline constexpr double kRangeMargin = 0.01;

/// Largest total limit violation of a sound plan; the audit may accept it.
inline constexpr double kSlightViolation = 1e-5;

/// Limit violations of joints and motors (Actuator), summed in shares of the limits; 0 if all limits are kept.
/// @param margin  margin to both ends of a joint's range, as a share of the range. It is part of the limit, except for
///               postures like the standing posture.
double TotalViolation(const RobotModel& model, const WholeBodyTrajectory& motion, double margin);

/// Limits of joints and motors that the trajectory violates, the worst of each joint or motor and kind.
std::vector<std::string> LimitWarnings(const RobotModel& model, const WholeBodyTrajectory& motion);

}  // namespace gaitwright
