// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "planning/plan/terrain.h"
#include "planning/tasks/task_plan.h"

namespace gaitwright {

/// The places of a ground that have names, by what people call them: markers as they are, patches of a name and a
/// number ("step 2") as several of that name, `number` being the highest; patches without a number as they are.
std::vector<PlaceName> PlacesOf(const Terrain& terrain);

/// The middle of a place in plan view [m]; of several without a number, of the last.
/// @throws InvalidArgument for a place that is not one of PlacesOf.
Vector2 CentreOf(const Terrain& terrain, const PlaceName& place);

}  // namespace gaitwright
