// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/words/interpret.h"

#include <fmt/format.h>

#include "kinematics/base/text.h"
#include "planning/tasks/task_plan_json.h"
#include "workflows/words/items.h"
#include "workflows/words/language_model.h"
#include "workflows/words/understand.h"

namespace gaitwright {
namespace {

std::string PlacesText(const TaskScope& scope) {
  std::string text;
  for (const PlaceName& place : scope.places) {
    const std::string numbers = place.number > 0 ? fmt::format(" (1 to {})", place.number) : "";
    text += fmt::format("{}\"{}\"{}", text.empty() ? "" : ", ", place.name, numbers);
  }
  return text.empty() ? "none" : text;
}

/// The text from the first to the last brace, since models often fence their JSON.
std::string JsonIn(const std::string& answer) {
  const std::size_t begin = answer.find('{'), end = answer.rfind('}');
  if (begin == std::string::npos || end == std::string::npos || end < begin) return Trimmed(answer);
  return answer.substr(begin, end + 1 - begin);
}

}  // namespace

std::string InterpreterPrompt(const TaskScope& scope) {
  return fmt::format(
      "You turn an instruction for the legged robot '{}' into a task plan: one JSON object that is valid by the schema "
      "below, and nothing else. Tasks are done one after the other; \"while\" of a task holds gestures made meanwhile. "
      "Leave out what the instruction does not say. Units are metres, seconds and degrees. Directions are the robot's "
      "own. Walking sideways is a walk to the left or right. \"words\" holds the part of the instruction that a task "
      "comes from. Use no action but those of the schema. Where something cannot be done with them, answer with an "
      "empty list of tasks.\n"
      "The places that have names: {}.\n"
      "Schema:\n{}",
      scope.robot, PlacesText(scope), TaskPlanSchema(scope.Actions()));
}

Result<TaskPlan> PlanInAnswer(const std::string& answer, const std::string& instruction, const TaskScope& scope) {
  Result<TaskPlan> plan = TaskPlanFromJson(JsonIn(answer));
  if (!plan) return plan;
  if (auto failure = ReasonNotPlanned(*plan, scope)) return *failure;
  plan->text = instruction;
  plan->language = words::LanguageOf(instruction) == words::Language::kEnglish ? "en" : "zh";
  return plan;
}

Result<TaskPlan> Grammar::Interpret(const std::string& instruction, const TaskScope& scope,
                                    std::vector<std::string>&) const {
  return words::UnderstandWords(instruction, scope);
}

Result<TaskPlan> ModelInterpreter::Interpret(const std::string& instruction, const TaskScope& scope,
                                             std::vector<std::string>& notes) const {
  constexpr int kAttempts = 2;
  std::vector<ChatMessage> messages = {{"system", InterpreterPrompt(scope)}, {"user", instruction}};
  for (int attempt = 1;; ++attempt) {
    const Result<std::string> answer = Complete(model_, messages);
    if (!answer) {
      notes.push_back(answer.failure().message);
      return answer.failure();
    }
    Result<TaskPlan> plan = PlanInAnswer(*answer, instruction, scope);
    if (plan) return plan;
    notes.push_back(fmt::format("the language model's answer is not valid: {}", plan.failure().message));
    if (attempt == kAttempts) return plan.failure();
    messages.push_back({"assistant", Shortened(*answer)});
    messages.push_back({"user", fmt::format("That is not valid: {}. Answer with the corrected JSON object alone.",
                                            plan.failure().message)});
  }
}

Result<Interpretation> InterpretBy(const std::vector<const Interpreter*>& interpreters, const std::string& instruction,
                                   const TaskScope& scope) {
  if (interpreters.empty()) throw InvalidArgument("InterpretBy needs an interpreter");
  Interpretation made;
  Failure failure;
  for (const Interpreter* interpreter : interpreters) {
    Result<TaskPlan> plan = interpreter->Interpret(instruction, scope, made.notes);
    if (plan) {
      made.plan = std::move(*plan);
      made.by = interpreter->name();
      return made;
    }
    failure = plan.failure();
    if (failure.code == FailureCode::kInterpreterUrl) return failure;
  }
  failure.suggestions.insert(failure.suggestions.end(), made.notes.begin(), made.notes.end());
  return failure;
}

Result<Interpretation> Interpret(const std::string& instruction, const TaskScope& scope,
                                 const std::optional<LanguageModel>& model) {
  const Grammar grammar;
  if (!model) return InterpretBy({&grammar}, instruction, scope);
  const ModelInterpreter by_model(*model);
  return InterpretBy({&by_model, &grammar}, instruction, scope);
}

}  // namespace gaitwright
