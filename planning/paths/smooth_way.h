// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "planning/paths/direct_way.h"
#include "planning/paths/pose_check.h"

namespace gaitwright {

/// A way among free poses made cheaper: parts are replaced by direct ways where those are free and cheaper (the best
/// choice of them over its waypoints), then waypoints are moved and turned while that is cheaper, coarsely first. Never
/// costs more than it did. Deterministic.
/// @param way  free, yaws unwrapped; first and last stay.
std::vector<PlanarPose> SmoothWay(PoseCheck& check, const std::vector<PlanarPose>& way, const TravelWeights& weights);

}  // namespace gaitwright
