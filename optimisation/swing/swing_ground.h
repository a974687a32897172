// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <utility>

#include "planning/plan/terrain.h"

namespace gaitwright {

/// The lowest and the highest of an obstacle on the upright line through a point [m], of the box about it along its own
/// axes; nothing where the line passes by.
std::optional<std::pair<double, double>> HeightsOf(const Obstacle& obstacle, const Vector2& p_W);

/// What a foot has to be lifted over at a point: the ground, and each obstacle that begins lower than `below_m`; what
/// begins higher, as a lintel, is not lifted over. -infinity where there is nothing.
double HeightToClear(const Terrain& terrain, const Vector2& p_W, double below_m);

}  // namespace gaitwright
