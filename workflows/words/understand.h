// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <variant>

#include "planning/tasks/task_rules.h"
#include "workflows/words/item.h"

namespace gaitwright::words {

/// Translates an instruction with the built-in grammar of English and Chinese: words by longest phrases (lexicon.h),
/// one task for each clause, see docs/words.md. Every word must be understood or be known to have no meaning.
/// @param scope  the abilities of the robot and the known places.
/// @return a plan whose tasks all pass ReasonNotPlanned, or the first part that is not accepted, with the reason.
std::variant<TaskPlan, Refusal> Understand(const std::string& text, const TaskScope& scope);

/// As Understand, as a Result: failures kBadInput with the code of the refusal.
Result<TaskPlan> UnderstandWords(const std::string& text, const TaskScope& scope);

}  // namespace gaitwright::words
