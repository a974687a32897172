// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "optimisation/search/plan_walk.h"
#include "planning/gait/read_sequence.h"

namespace gaitwright {

/// A plan of several parts that passes its audit, or the reason why there is none; see PlanWalk. If the whole plan
/// fails with the gaits as fitted to their speeds, each walking part is planned alone to find its cycle time and its
/// feasible speed. The failure names a part without a plan by its number and gait.
Result<PlannedWalk> PlanPartsWithin(const RobotModel& model, const Terrain& terrain, const WalkRequest& request,
                                    const std::vector<AskedPart>& asked, SearchTrace* trace = nullptr);

}  // namespace gaitwright
