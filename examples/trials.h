// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "playback/trials/robustness_report.h"

namespace gaitwright::examples {

/// What trials of a walk showed.
struct TriedWalk {
  RobustnessReport report;
  TrialOutcome worst;     ///< of the trial with the lowest score
  TrialOutcome repeated;  ///< of the same, played once more from its seed alone
};

/// A plan that is good once need not be good: walks 1 m many times, each time with another mass, ground and push,
/// behind the sensors of a small budget. The share that survives is an estimate, and its interval says how good a one.
/// @param disturbances  path of a file of what is drawn for each trial, see docs/trials.md.
/// @param seed          of the whole study; each trial has its own, which is all it takes to repeat it.
/// @throws InvalidArgument with the reason, for a file that is wrong or a robot that cannot walk.
TriedWalk TryWalk(const std::string& robot, const std::string& disturbances, int trials, int seed);

}  // namespace gaitwright::examples
