// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "optimisation/search/plan_walk.h"
#include "optimisation/search/search_trace.h"

namespace gaitwright {

/// PlanWalk for a gait in which the body turns over once, which has its own travel (OwnTravel). Travel and flight are
/// varied until a plan is sound and keeps room for controllers; if no plan does, the first sound one is returned.
/// Failure kBadInput if the request has a speed, another distance than the default, a goal or steps; the failure of the
/// first candidate if no plan is sound.
Result<PlannedWalk> PlanTurn(const RobotModel& model, const Terrain& terrain, const WalkRequest& request,
                             SearchTrace* trace);

}  // namespace gaitwright
