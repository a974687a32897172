// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/model/robot_model.h"
#include "playback/play/play.h"

namespace gaitwright::playing {

/// All pushes of the options that have a force and a duration.
std::vector<TimedPush> PushesOf(const PlayOptions& options);

/// The target of a push: a body of the model, or kWholeRobot. @throws InvalidArgument naming the nearest link.
int PushedBody(const RobotModel& model, const std::string& on);
inline constexpr int kWholeRobot = -1;

/// Share of the step from `time_s` on during which a push acts, so that its impulse is exact for any duration. A share
/// that differs from 1 by rounding is 1.
double ShareOfStep(const TimedPush& push, double time_s, double step_s);

/// Whether the options displace the start from the plan.
bool StartsOff(const PlayOptions& options);

/// The first configuration with the options' displacement. @throws InvalidArgument if `start_joints` has a wrong size.
VectorX MovedOff(const RobotModel& model, const PlayOptions& options, VectorX q);

}  // namespace gaitwright::playing
