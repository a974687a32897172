// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/words/interpret.h"

#include <fmt/format.h>

#include "kinematics/base/text.h"
#include "planning/tasks/task_plan_json.h"
#include "workflows/words/items.h"
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

/// What stands between the first brace and the last: models like to fence their JSON.
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
  if (auto failure = WhyNotPlanned(*plan, scope)) return *failure;
  plan->text = instruction;
  plan->language = words::LanguageOf(instruction) == words::Language::kEnglish ? "en" : "zh";
  return plan;
}

Result<Interpretation> Interpret(const std::string& instruction, const TaskScope& scope,
                                 const std::optional<LanguageModel>& model) {
  constexpr int kAttempts = 2;
  Interpretation made;
  if (model) {
    std::vector<ChatMessage> messages = {{"system", InterpreterPrompt(scope)}, {"user", instruction}};
    for (int attempt = 0; attempt < kAttempts; ++attempt) {
      const Result<std::string> answer = Complete(*model, messages);
      if (!answer && answer.failure().code == FailureCode::kInterpreterUrl) return answer.failure();
      if (!answer) {
        made.notes.push_back(answer.failure().message);
        break;
      }
      Result<TaskPlan> plan = PlanInAnswer(*answer, instruction, scope);
      if (plan) {
        made.plan = std::move(*plan);
        made.by = "language model";
        return made;
      }
      made.notes.push_back(fmt::format("the language model's answer is not valid: {}", plan.failure().message));
      messages.push_back({"assistant", Shortened(*answer)});
      messages.push_back({"user", fmt::format("That is not valid: {}. Answer with the corrected JSON object alone.",
                                              plan.failure().message)});
    }
  }
  Result<TaskPlan> plan = words::UnderstandWords(instruction, scope);
  if (!plan) {
    Failure failure = plan.failure();
    failure.suggestions.insert(failure.suggestions.end(), made.notes.begin(), made.notes.end());
    return failure;
  }
  made.plan = std::move(*plan);
  made.by = "grammar";
  return made;
}

}  // namespace gaitwright
