// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "planning/plan/terrain.h"
#include "planning/tasks/task_plan.h"

namespace gaitwright {

/// The ground before stairs and behind them, which have no patches of their own: as far from the steps as the robot is
/// where it begins. There are both of "step 1", "step 2", ... and of "step 1 down", ...
inline constexpr char kStartOfStairs[] = "start of the stairs", kEndOfStairs[] = "end of the stairs";

/// The places of a ground that have names, by what people call them: markers as they are, patches of a name and a
/// number ("step 2") as several of that name, `number` being the highest; patches without a number as they are; the two
/// ends of stairs.
std::vector<PlaceName> PlacesOf(const Terrain& terrain);

/// The middle of a place in plan view [m]; of several without a number, of the last.
/// @throws InvalidArgument for a place that is not one of PlacesOf.
Vector2 CentreOf(const Terrain& terrain, const PlaceName& place);

}  // namespace gaitwright
