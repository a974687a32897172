// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "planning/tasks/task_rules.h"
#include "workflows/words/language_model.h"

namespace gaitwright {

/// What an instruction was taken to mean, and by what.
struct Interpretation {
  TaskPlan plan;
  std::string by;                  ///< "grammar" or "language model"
  std::vector<std::string> notes;  ///< why the language model's answers were not taken
};

/// What a language model is told before an instruction: what this robot can do, where, and the schema of the answer.
std::string InterpreterPrompt(const TaskScope& scope);

/// The task plan in a language model's answer, as JSON alone or fenced. Failures as of TaskPlanFromJson and
/// WhyNotPlanned: nothing that is not valid for this robot is let pass.
Result<TaskPlan> PlanInAnswer(const std::string& answer, const std::string& instruction, const TaskScope& scope);

/// An instruction as a task plan: by the language model where one is given, asked once more with the error where its
/// answer is not valid; then by the built-in grammar. Failure: the grammar's refusal.
Result<Interpretation> Interpret(const std::string& instruction, const TaskScope& scope,
                                 const std::optional<LanguageModel>& model);

}  // namespace gaitwright
