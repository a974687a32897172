// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "planning/plan/json_part_internal.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// Names of WalkCommand::Extent in files, in its order.
const std::vector<std::string>& PlanExtents();

/// Reads a plan from JSON with known format and schema. @throws InvalidArgument that names the first entry that is
/// missing, unknown, of the wrong kind or out of range.
MotionPlan ReadPlan(const JsonPart& whole);

}  // namespace gaitwright
