// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/base/result.h"
#include "planning/terrain/written_ground.h"

namespace gaitwright {

/// The heights of a ground as a grey PNG of 16 bits, which ReadHeightMap reads back: the highest surface at the nodes
/// of a grid over the extent of the ground (ExtentOf, without obstacles). Obstacles are left out.
///
/// The grid is that of the first height field, refined to 0.02 m or less, so that heights between its nodes are kept;
/// else it has nodes 0.02 m apart, about the middle of the extent. It is coarser by a whole factor where it would have
/// more than 4096 nodes along x or y or more than kMostNodes in all.
/// Black is the lowest height; where a node has no ground, it is black and kSolidDepth below the lowest height.
/// Failure kBadInput: a ground without surfaces, one that is too large for kMostNodes nodes 1 m apart, heights that
/// differ by more than kHighest, or those of neighbouring nodes by more than kSteepestStep.
Result<WrittenGround> WriteHeights(const Terrain& terrain);

}  // namespace gaitwright
