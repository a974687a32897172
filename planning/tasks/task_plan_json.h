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
/// `while` of a task holds gestures that run at the same time; `to` is {"name": "step", "number": 2}.
std::string TaskPlanJson(const TaskPlan& plan);

/// Reads the output of TaskPlanJson; `text`, `language` and `words` may be left out. Failure kBadInput `task_plan`
/// names the path of the wrong entry: invalid JSON, an unknown schema, unknown keys (with the nearest known key),
/// values of another kind or out of range (ReasonNoTask). It is not checked whether the robot can do the tasks.
Result<TaskPlan> TaskPlanFromJson(const std::string& text);

/// The JSON schema (draft 2020-12) of task plans, made from the rules.
/// @param actions  actions that the schema allows; empty for all.
std::string TaskPlanSchema(const std::vector<std::string>& actions = {});

}  // namespace gaitwright
