// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "optimisation/search/plan_walk.h"

namespace gaitwright {

/// A plan that passes its audit, or the failure with a feasible alternative; see PlanWalk.
Result<PlannedWalk> PlanWithin(const RobotModel& model, const Terrain& terrain, const WalkRequest& request,
                               SearchTrace* trace = nullptr);

}  // namespace gaitwright
