// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/base/result.h"
#include "planning/tasks/task_rules.h"
#include "workflows/words/item.h"

namespace gaitwright::words {

/// The failure for a refusal: the part, the error, and what to say instead. Lists the robot's actions only if they are
/// relevant.
Failure FailureOf(const Refusal& refusal, const TaskScope& scope);

/// Converts suggestions of a planner with command-line flags, such as "--speed 0.4", to words to say: "at 0.4 m/s".
/// Suggestions that words cannot express are left out.
/// @param footfalls  footfalls per step in words: one, or one for each foot of a robot with more than two feet.
std::vector<Suggestion> SuggestionsInWords(const std::vector<Suggestion>& suggestions, int footfalls);

}  // namespace gaitwright::words
