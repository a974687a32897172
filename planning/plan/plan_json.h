// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/base/result.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// The plan as JSON text (docs/plan-format.md). Deterministic to the byte.
std::string PlanToJson(const MotionPlan& plan);

/// JSON text: [{"what", "asked", "given", "unit", "why", "part"}]
std::string AdjustmentsJson(const std::vector<Adjustment>& adjustments);

/// Hash of the whole plan as written: any relevant change of its file changes it.
std::string PlanHash(const MotionPlan& plan);

/// A plan from its JSON text. Refused with the reason: truncated text, text that is not a plan, another schema, a
/// missing key or one of the wrong kind, inconsistent sizes. @param source names the text in messages.
Result<MotionPlan> PlanFromJson(const std::string& text, const std::string& source);

/// Writes atomically. @return the path.
Result<std::string> SavePlan(const MotionPlan& plan, const std::string& path);
/// The plan of a file; refused as by PlanFromJson, or if there is no such file.
Result<MotionPlan> LoadPlan(const std::string& path);

}  // namespace gaitwright
