// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "kinematics/model/robot_model.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// The quantity of a command that says how fast it is, or with counted steps of a given length how far a step goes.
enum class Pace { kSpeed, kLateralSpeed, kYawRate, kStepLength };
Pace PaceOf(const WalkCommand& command);
/// Its value, not negative; the robot's own speed where the command gives none.
double PaceValue(const RobotModel& model, const WalkCommand& command);

/// "speed", "turning rate"
std::string PaceName(Pace pace);
/// The command's flag without dashes: `speed`, `lateral-speed`, `yaw-rate`, `step-length`.
std::string PaceFlag(Pace pace);
/// "m/s", "rad/s" or "m"
std::string PaceUnit(Pace pace);
/// A command's pace with its unit: "0.8 m/s".
std::string PaceText(const WalkCommand& command);
/// The flags that ask for a pace and what goes with it: "--speed 1.1 --yaw-rate 0.2".
std::string PaceFlags(const WalkCommand& command);

/// The same walk with its pace at `value`, positive, and every other speed in proportion, to four digits. The robot's
/// own speed counts where the command gives none.
WalkCommand AtPace(const RobotModel& model, const WalkCommand& command, double value);

/// A pace that no leg reaches: three times that of a pendulum of the leg's length, or a step of two legs' lengths.
double UnreachablePace(const RobotModel& model, Pace pace);

}  // namespace gaitwright
