// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>
#include <vector>

#include "planning/paths/travel_cost.h"

namespace gaitwright {

/// Ways from a pose to another without going around anything.
enum class DirectWay {
  kTwist,     ///< a constant twist of the body: an arc
  kStraight,  ///< straight, turning evenly
  kAhead,     ///< turns towards the goal, walks forward, turns
  kBackward   ///< turns away from the goal, walks backward, turns
};

inline constexpr DirectWay kDirectWays[] = {DirectWay::kTwist, DirectWay::kStraight, DirectWay::kAhead,
                                            DirectWay::kBackward};

/// How far apart waypoints are at most.
struct Spacing {
  double way_m = 0.05;
  double turn_rad = 0.1;
};

/// Waypoints of a direct way, a first and b last. The yaw of b is taken as the nearest to that before it.
std::vector<PlanarPose> WaypointsOf(DirectWay kind, const PlanarPose& a, const PlanarPose& b, const Spacing& spacing);

/// Cost of a direct route, see TravelCost.
double CostOf(DirectWay kind, const PlanarPose& a, const PlanarPose& b, const TravelWeights& weights);

/// A way with more waypoints between those that it has, and none twice.
std::vector<PlanarPose> Densified(const std::vector<PlanarPose>& way, const Spacing& spacing);

/// The direct ways by their cost, the cheapest first.
std::vector<std::pair<double, DirectWay>> ByCost(const PlanarPose& a, const PlanarPose& b,
                                                 const TravelWeights& weights);

}  // namespace gaitwright
