// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "planning/paths/direct_route.h"
#include "planning/paths/pose_check.h"

namespace gaitwright {

/// Makes a path among free poses cheaper. First, parts are replaced by direct paths where these are free and cheaper
/// (the best choice over the waypoints). Then waypoints are moved and rotated while this reduces the cost, with large
/// steps first. Never increases the cost. Deterministic.
/// @param path  free, yaws unwrapped; first and last pose are kept.
std::vector<PlanarPose> SmoothRoute(PoseCheck& check, const std::vector<PlanarPose>& path,
                                    const TravelWeights& weights);

}  // namespace gaitwright
