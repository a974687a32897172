// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>
#include <vector>

#include "planning/paths/travel_cost.h"

namespace gaitwright {

/// Direct paths from a pose to another one, which ignore obstacles.
enum class DirectRoute {
  kTwist,     ///< constant planar twist: an arc
  kStraight,  ///< straight line with a constant yaw rate
  kForward,   ///< turns towards the goal, walks forward, turns
  kBackward   ///< turns away from the goal, walks backward, turns
};

inline constexpr DirectRoute kDirectRoutes[] = {DirectRoute::kTwist, DirectRoute::kStraight, DirectRoute::kForward,
                                                DirectRoute::kBackward};

/// Largest distances between waypoints.
struct Spacing {
  double distance_m = 0.05;
  double turn_rad = 0.1;
};

/// Waypoints of a direct path from a to b. The yaw of b is unwrapped to the value nearest to the previous yaw.
std::vector<PlanarPose> WaypointsOf(DirectRoute kind, const PlanarPose& a, const PlanarPose& b, const Spacing& spacing);

/// Cost of a direct path, see TravelCost.
double CostOf(DirectRoute kind, const PlanarPose& a, const PlanarPose& b, const TravelWeights& weights);

/// A path with additional waypoints between its own, without duplicates.
std::vector<PlanarPose> Densified(const std::vector<PlanarPose>& path, const Spacing& spacing);

/// The direct paths with their costs, the cheapest first.
std::vector<std::pair<double, DirectRoute>> ByCost(const PlanarPose& a, const PlanarPose& b,
                                                   const TravelWeights& weights);

}  // namespace gaitwright
