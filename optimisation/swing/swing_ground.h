// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <utility>

#include "planning/plan/terrain.h"

namespace gaitwright {

/// Lowest and highest point of an obstacle's bounding box on the vertical line through a point [m]; nothing if the line
/// misses it.
std::optional<std::pair<double, double>> HeightsOf(const Obstacle& obstacle, const Vector2& p_W);

/// Height that a foot must be lifted above at a point: the ground, and each obstacle that starts below `below_m`; an
/// obstacle that starts higher, such as a lintel, is ignored. -infinity if there is nothing.
double HeightToClear(const Terrain& terrain, const Vector2& p_W, double below_m);

}  // namespace gaitwright
