// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "planning/tasks/task_rules.h"
#include "workflows/words/draft.h"

namespace gaitwright::words {

/// Whether an action has a parameter.
bool Takes(const std::string& action, const std::string& key);

/// Holds a task, and what is done meanwhile, against the rules and what the robot can do. @throws Refused by the words
/// that say what is not accepted.
void CheckDraft(const std::string& text, const TaskScope& scope, const Task& task, const Draft& draft);

}  // namespace gaitwright::words
