// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "planning/tasks/task_rules.h"
#include "workflows/words/draft.h"

namespace gaitwright::words {

/// Whether an action has a parameter.
bool Takes(const std::string& action, const std::string& key);

/// Checks a task and its simultaneous gestures against the rules and the abilities of the robot. @throws Refused with
/// the words that are not accepted.
void CheckDraft(const std::string& text, const TaskScope& scope, const Task& task, const Draft& draft);

}  // namespace gaitwright::words
