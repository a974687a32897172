// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "playback/trials/robustness_report.h"

namespace gaitwright::examples {

/// Results of trials of a walk.
struct TriedWalk {
  RobustnessReport report;
  TrialOutcome worst;     ///< the trial with the lowest score
  TrialOutcome repeated;  ///< the same trial, repeated from its seed alone
};

/// Plays a walk of 1 m many times, each time with a different mass, ground and push, and with low-cost sensors.
/// A plan that passes once may fail under disturbances. The survival rate is an estimate; its confidence interval says
/// how accurate it is.
/// @param disturbances  path of a file with the distributions that each trial samples; see docs/trials.md.
/// @param seed          seed of the study. Each trial has a seed from it, which is enough to repeat that trial.
/// @throws InvalidArgument if the file is invalid, or if the robot cannot walk.
TriedWalk TryWalk(const std::string& robot, const std::string& disturbances, int trials, int seed);

}  // namespace gaitwright::examples
