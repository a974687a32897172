// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/base/result.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// The plan as JSON text (docs/plan-format.md). Equal plans give equal bytes.
std::string PlanToJson(const MotionPlan& plan);

/// JSON text: [{"what", "asked", "given", "unit", "why", "part"}]
std::string AdjustmentsJson(const std::vector<Adjustment>& adjustments);

/// Hash of the plan's JSON text; it changes with every relevant change of the plan.
std::string PlanHash(const MotionPlan& plan);

/// Reads a plan from its JSON text. Fails, with the reason, for truncated text, text that is not a plan, another
/// schema, a key that is missing or has a value of the wrong kind, and inconsistent sizes. @param source  name of the
/// text in messages.
Result<MotionPlan> PlanFromJson(const std::string& text, const std::string& source);

/// Writes atomically. @return the path.
Result<std::string> SavePlan(const MotionPlan& plan, const std::string& path);
/// Reads a plan file; fails as PlanFromJson does, or if the file does not exist.
Result<MotionPlan> LoadPlan(const std::string& path);

}  // namespace gaitwright
