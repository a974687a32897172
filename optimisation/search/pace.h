// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "kinematics/model/robot_model.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// The quantity that sets the speed of a command: a speed, or the step length for counted steps of a given length.
enum class Pace { kSpeed, kLateralSpeed, kYawRate, kStepLength };
Pace PaceOf(const WalkCommand& command);
/// Value of this quantity, not negative; the robot's default speed if the command gives none.
double PaceValue(const RobotModel& model, const WalkCommand& command);

/// Name for messages: "speed", "turning rate".
std::string PaceName(Pace pace);
/// The command's flag without dashes: `speed`, `lateral-speed`, `yaw-rate`, `step-length`.
std::string PaceFlag(Pace pace);
/// Unit: "m/s", "rad/s" or "m".
std::string PaceUnit(Pace pace);
/// Value and unit of a command's speed: "0.8 m/s".
std::string PaceText(const WalkCommand& command);
/// The flags that request this speed and the speeds in proportion to it: "--speed 1.1 --yaw-rate 0.2".
std::string PaceFlags(const WalkCommand& command);

/// The same walk with its speed changed to `value` (positive) and every other speed in proportion, to four digits. The
/// robot's default speed is used if the command gives none.
WalkCommand AtPace(const RobotModel& model, const WalkCommand& command, double value);

/// A speed that no leg reaches: three times that of a pendulum of the leg's length, or a step of two leg lengths.
double UnreachablePace(const RobotModel& model, Pace pace);

}  // namespace gaitwright
