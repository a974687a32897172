// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <variant>

#include "planning/tasks/task_rules.h"
#include "workflows/words/item.h"

namespace gaitwright::words {

/// What an instruction asks for, by the built-in grammar of English and Chinese: words by longest phrases (lexicon.h),
/// one task for each clause, as docs/words.md tells. Every word has to be understood, or to be one that says nothing.
/// @param scope  what the robot can do and which places there are.
/// @return a plan whose tasks all are within WhyNotPlanned, or the first part that is not accepted, and why.
std::variant<TaskPlan, Refusal> Understand(const std::string& text, const TaskScope& scope);

/// The same as a Result: failures kBadInput with the refusal's reason as code.
Result<TaskPlan> UnderstandWords(const std::string& text, const TaskScope& scope);

}  // namespace gaitwright::words
