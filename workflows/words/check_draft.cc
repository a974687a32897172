// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/words/check_draft.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace gaitwright::words {
namespace {

/// A task with this parameter and the required ones only.
Task Alone(const Task& task, const std::string& key, const ActionRule& rule) {
  Task alone{task.action, {{key, task.parameters.at(key)}}, "", {}};
  for (const std::string& required : rule.required) {
    const auto there = task.parameters.find(required);
    alone.parameters.try_emplace(required, there == task.parameters.end() ? TaskValue(std::string()) : there->second);
  }
  if (key == "step_length_m") alone.parameters.try_emplace("steps", 1);
  return alone;
}

std::string ReasonNotTaken(const ActionRule& rule, const std::string& key) {
  if (key == "to" && rule.action == "turn")
    return "is a place, but a turn needs a direction (left or right) and degrees";
  if (key == "to")
    return fmt::format("is a place, but '{}' is done at the robot's present place: walk there first", rule.action);
  return fmt::format("cannot be used with '{}'", rule.action);
}

void CheckParameter(const std::string& text, const TaskScope& scope, const Task& task, const Draft& draft,
                    const std::string& key) {
  const ActionRule& rule = *FindAction(task.action);
  const std::string words = TextOf(text, SpanOf(draft, key));
  if (!Takes(rule.action, key)) throw Refused{{FailureCode::kUnknown, words, ReasonNotTaken(rule, key), ""}};
  const Task alone = Alone(task, key, rule);
  const auto failure = ReasonNoTask(alone);
  if (failure && failure->code == FailureCode::kRange)
    throw Refused{{FailureCode::kRange, words, failure->message, "", "", true}};
  if (key != "to") return;
  if (const auto away = ReasonNotDone(alone, scope); away && away->code == FailureCode::kPlace)
    throw Refused{{FailureCode::kPlace, words, away->message, "", "", true}};
}

void CheckExtents(const std::string& text, const Task& task, const Draft& draft) {
  std::optional<Span> extent;
  for (const std::string& key : ExtentKeys()) {
    if (task.action != "walk" || !task.Has(key)) continue;
    const Span span = SpanOf(draft, key);
    if (extent) {
      const Span both = {std::min(extent->begin, span.begin), std::max(extent->end, span.end)};
      throw Refused{
          {FailureCode::kAmbiguous, TextOf(text, both), "sets the distance twice: give an amount or a place", ""}};
    }
    extent = span;
  }
}

/// The accepted words of a missing parameter.
std::string WhatToSay(const std::string& action, const std::string& key) {
  if (action == "flip") return "'backflip' or 'barrel roll'";
  if (key == "direction") return "left or right";
  return fmt::format("one of {}", fmt::join(FindParameter(key)->words, ", "));
}

/// Checks "walk sideways", which needs a side.
void CheckSideways(const std::string& text, const Task& task, const Draft& draft) {
  if (!draft.sideways || task.action == "lower_arm") return;  // arms hang at the sides
  const std::string words = TextOf(text, *draft.sideways);
  if (task.action != "walk")
    throw Refused{{FailureCode::kUnknown, words, fmt::format("cannot be used with '{}'", task.action), ""}};
  if (task.Word("direction") != "left" && task.Word("direction") != "right")
    throw Refused{{FailureCode::kAmbiguous, words, "does not give a side", "", "left or right"}};
}

}  // namespace

bool Takes(const std::string& action, const std::string& key) {
  const ActionRule& rule = *FindAction(action);
  return std::find(rule.optional.begin(), rule.optional.end(), key) != rule.optional.end() ||
         std::find(rule.required.begin(), rule.required.end(), key) != rule.required.end();
}

void CheckDraft(const std::string& text, const TaskScope& scope, const Task& task, const Draft& draft) {
  if (draft.bare)
    throw Refused{{FailureCode::kAmbiguous, TextOf(text, {draft.bare->begin, draft.bare->end}), "has no unit", "",
                   "a unit: metres, steps, degrees, seconds or times"}};
  const ActionRule& rule = *FindAction(task.action);
  if (!scope.Can(rule)) {
    const Task bare{task.action, {}, "", {}};
    throw Refused{
        {FailureCode::kCannot, TextOf(text, draft.words), ReasonNotDone(bare, scope)->message, rule.instead, "", true}};
  }
  if (draft.side) {
    const std::string words = TextOf(text, draft.side_said.value_or(draft.words));
    throw Refused{
        {FailureCode::kUnknown, words, fmt::format("cannot be used with '{}', which has no sides", rule.action), ""}};
  }
  CheckSideways(text, task, draft);
  for (const auto& [key, value] : task.parameters) CheckParameter(text, scope, task, draft, key);
  CheckExtents(text, task, draft);
  const bool goes =
      std::any_of(ExtentKeys().begin(), ExtentKeys().end(), [&](const auto& key) { return task.Has(key); });
  if (draft.to_nowhere && (task.action == "walk" || task.action == "jump") && !goes)
    throw Refused{{FailureCode::kPlace, TextOf(text, draft.words), "does not give a destination", ""}};
  for (const std::string& required : rule.required) {
    if (!task.Has(required))
      throw Refused{{FailureCode::kAmbiguous, TextOf(text, draft.words), fmt::format("does not give the {}", required),
                     "", WhatToSay(task.action, required)}};
  }
  for (std::size_t k = 0; k < task.during.size(); ++k) CheckDraft(text, scope, task.during[k], draft.during[k]);
}

}  // namespace gaitwright::words
