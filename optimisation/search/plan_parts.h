// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "optimisation/search/plan_walk.h"
#include "planning/gait/read_sequence.h"

namespace gaitwright {

/// A plan of several parts that passes its audit, or why there is none: see PlanWalk. Where the whole does not pass
/// with gaits as they are fitted to their speeds, each part that walks is planned by itself to find its time and what
/// it can do; a part that has no plan alone is named by its number and gait.
Result<PlannedWalk> PlanPartsWithin(const RobotModel& model, const Terrain& terrain, const WalkRequest& request,
                                    const std::vector<AskedPart>& asked, SearchTrace* trace = nullptr);

}  // namespace gaitwright
