// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/model/robot_model.h"
#include "playback/play/play.h"

namespace gaitwright::playing {

/// All pushes of the options that are pushes at all.
std::vector<TimedPush> PushesOf(const PlayOptions& options);

/// What a push acts on: a body of the model, or kWholeRobot. @throws InvalidArgument naming the nearest link.
int PushedBody(const RobotModel& model, const std::string& on);
inline constexpr int kWholeRobot = -1;

/// The share of the step from `time_s` on in which a push acts, so that its impulse is what it says however short it
/// is; a whole step but for rounding is one.
double ShareOfStep(const TimedPush& push, double time_s, double step_s);

/// Whether a robot starts off its plan.
bool StartsOff(const PlayOptions& options);

/// A first configuration moved off the plan's. @throws InvalidArgument when `start_joints` has a wrong size.
VectorX MovedOff(const RobotModel& model, const PlayOptions& options, VectorX q);

}  // namespace gaitwright::playing
