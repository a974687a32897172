// SPDX-License-Identifier: BSD-3-Clause
#include "tests/fuzz/words_readers.h"

#include <cmath>
#include <variant>

#include "planning/tasks/task_plan_json.h"
#include "planning/tasks/task_rules.h"
#include "workflows/words/understand.h"

namespace gaitwright::fuzz {
namespace {

/// A robot with all abilities, on a ground with named places.
TaskScope Scope() {
  TaskScope scope;
  scope.robot = "any";
  scope.left_arm = scope.right_arm = scope.head = scope.two_soles = scope.four_feet = true;
  scope.many_feet = scope.turning_feet = true;
  scope.places = {{"red marker", 0}, {"stone", 6}, {"门", 0}};
  return scope;
}

void RequireWithinRules(const Task& task) {
  for (const auto& [key, value] : task.parameters) {
    const ParameterRule* rule = FindParameter(key);
    Require(rule != nullptr, "every parameter exists");
    if (const auto* number = std::get_if<double>(&value))
      Require(std::isfinite(*number) && *number >= rule->lowest && *number <= rule->highest,
              "a number is in its range");
    if (const auto* count = std::get_if<int>(&value); count != nullptr)
      Require(*count >= rule->lowest && *count <= rule->highest, "a count is in its range");
  }
  for (const Task& gesture : task.during) RequireWithinRules(gesture);
}

Verdict ReadTaskPlan(const std::string& input) {
  const Result<TaskPlan> plan = TaskPlanFromJson(input);
  if (!plan) return Verdict::kRefused;
  for (const Task& task : plan->tasks) RequireWithinRules(task);
  const Result<TaskPlan> again = TaskPlanFromJson(TaskPlanJson(*plan));
  Require(again.ok() && *again == *plan, "a task plan is read back as it was written");
  return Verdict::kAccepted;
}

Verdict ReadInstruction(const std::string& input) {
  const auto understood = words::Understand(input, Scope());
  const auto* plan = std::get_if<TaskPlan>(&understood);
  if (plan == nullptr) {
    Require(std::get<words::Refusal>(understood).code != FailureCode::kInternal, "a refusal has its reason");
    return Verdict::kRefused;
  }
  Require(!ReasonNotPlanned(*plan, Scope()), "an understood instruction can be planned");
  for (const Task& task : plan->tasks) RequireWithinRules(task);
  return Verdict::kAccepted;
}

std::vector<std::string> MadeTaskPlans() {
  std::vector<std::string> made;
  for (const char* text : {"walk to the second stone while waving, then squat twice", "起来，小跑两米，然后坐下十秒"}) {
    const auto understood = words::Understand(text, Scope());
    if (const auto* plan = std::get_if<TaskPlan>(&understood)) made.push_back(TaskPlanJson(*plan));
  }
  return made;
}

std::vector<std::string> MadeInstructions() {
  return {"Walk two and a half metres at 0.3 m/s, then raise both arms.",
          "turn left, no, right 45 degrees, and wave twice", "Before you bow, nod; sit for half a minute.",
          "一边向前走一边挥左手，再往后退一米二", "左转九十度，不对，六十度，然后趴下"};
}

}  // namespace

std::vector<Reader> WordsReaders() {
  return {{"task_plan",
           ReadTaskPlan,
           {"{",      "}",          "[",          "]",         ":",          ",",        "null",
            "1e400",  "-1",         "\"schema\"", "\"tasks\"", "\"action\"", "\"walk\"", "\"direction\"",
            "\"to\"", "\"number\"", "\"while\"",  "\"steps\"", "\"times\"",  "\"words\""},
           {},
           MadeTaskPlans},
          {"instruction",
           ReadInstruction,
           {" then ", ", ",   " no ", " while ", " before ", "again", "walk", "turn", "left", "wave",
            "3",      "half", "a",    "metre",   "seconds",  "stone", "然后", "不对", "一边", "走",
            "转",     "手",   "两",   "半",      "米",       "秒",    "门",   "第"},
           {},
           MadeInstructions}};
}

}  // namespace gaitwright::fuzz
