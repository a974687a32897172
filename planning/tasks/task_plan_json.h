// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "kinematics/base/result.h"
#include "planning/tasks/task_plan.h"

namespace gaitwright {

/// A task plan as JSON, for people and programs:
///
///     {"schema": 1, "text": "walk two steps, then wave", "language": "en",
///      "tasks": [{"action": "walk", "direction": "forward", "steps": 2, "words": "walk two steps"},
///                {"action": "wave", "side": "right", "words": "wave"}]}
///
/// `while` of a task holds gestures that are made meanwhile; `to` is {"name": "step", "number": 2}.
std::string TaskPlanJson(const TaskPlan& plan);

/// Reads the same; `text`, `language` and `words` may be left out. Failure kBadInput `task_plan` with the way to what
/// is wrong: no JSON, a schema that is not known, keys that are unknown (the nearest is named), values of another kind
/// or out of their ranges (WhyNoTask). What the robot can do is not looked at.
Result<TaskPlan> TaskPlanFromJson(const std::string& text);

/// The JSON schema (draft 2020-12) of task plans, made from the rules.
/// @param actions  that it lets pass; empty for all.
std::string TaskPlanSchema(const std::vector<std::string>& actions = {});

}  // namespace gaitwright
