// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/base/result.h"
#include "planning/tasks/task_rules.h"
#include "workflows/words/item.h"

namespace gaitwright::words {

/// What a refusal tells a person: the part, what is wrong with it, and what to say instead. What the robot can do is
/// listed only where that is the question.
Failure FailureOf(const Refusal& refusal, const TaskScope& scope);

/// Suggestions of a planner with flags of the command line, such as "--speed 0.4", as words to say: "at 0.4 m/s". What
/// no words say is left out.
/// @param footfalls  of a step as words have it: one, or one of each foot of a robot with more than two.
std::vector<Suggestion> SuggestionsInWords(const std::vector<Suggestion>& suggestions, int footfalls);

}  // namespace gaitwright::words
