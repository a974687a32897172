// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/base/result.h"
#include "planning/terrain/written_ground.h"

namespace gaitwright {

/// The heights of a ground as a 16-bit grey PNG, which ReadHeightMap can read: the highest surface at the points of a
/// grid over the extent of the ground (ExtentOf, without obstacles). Obstacles are left out.
///
/// The grid is that of the first height field, refined to 0.02 m or less so that heights between its points are kept.
/// Without a height field it has points 0.02 m apart, symmetric to the middle of the extent. It is coarsened by a whole
/// factor if it would have more than 4096 points along x or y, or more than kMostNodes in all.
/// Black is the lowest height. If some points have no ground, they are black, and black is kSolidDepth below the lowest
/// ground.
/// Failure kBadInput: a ground without surfaces; a ground too large for kMostNodes points 1 m apart; a height range of
/// more than kHighest; a height difference of more than kSteepestStep between neighbouring points.
Result<WrittenGround> WriteHeights(const Terrain& terrain);

}  // namespace gaitwright
