// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "optimisation/search/plan_walk.h"

namespace gaitwright {

/// A plan that passes its audit, or the failure with a feasible alternative; see PlanWalk.
Result<PlannedWalk> PlanWithin(const RobotModel& model, const Terrain& terrain, const WalkRequest& request,
                               SearchTrace* trace = nullptr);

/// PlanWithin in the smallest number of equal strides whose plan leaves motors ample room for the corrections of
/// controllers, from `strides` on; if no plan does, the first with the room of the optimisation
/// (FinishReport::keeps_room), or the first sound plan. A few numbers are tried. The failure is that of the first
/// number, as the search for more strides is its alternative.
Result<PlannedWalk> PlanInFewestStrides(const RobotModel& model, const Terrain& terrain, const WalkRequest& request,
                                        int strides, SearchTrace* trace = nullptr);

}  // namespace gaitwright
