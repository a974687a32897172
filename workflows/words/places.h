// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "planning/plan/terrain.h"
#include "planning/tasks/task_plan.h"

namespace gaitwright {

/// Places before and behind stairs, which have no patches: at the same distance from the steps as the robot's start.
/// Both exist for stairs of patches "step 1", "step 2", ... and of patches "step 1 down", ...
inline constexpr char kStartOfStairs[] = "start of the stairs", kEndOfStairs[] = "end of the stairs";

/// The named places of a ground: markers; patches without a number; patches with a name and a number ("step 2"), as one
/// entry per name whose `number` is the highest; and the two ends of stairs.
std::vector<PlaceName> PlacesOf(const Terrain& terrain);

/// The centre of a place in plan view [m]; for several places of one name without a number, that of the last one.
/// @throws InvalidArgument for a place that is not one of PlacesOf.
Vector2 CentreOf(const Terrain& terrain, const PlaceName& place);

/// Whether a patch of the ground has the name and number of a place.
bool IsPlace(const std::string& patch, const PlaceName& place, const Terrain& terrain);

}  // namespace gaitwright
