// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "planning/paths/coarse_route.h"
#include "planning/paths/pose_check.h"
#include "planning/paths/travel_cost.h"

namespace gaitwright {

/// Problem of the RRT* search.
struct RrtStarProblem {
  PlanarPose start, goal;  ///< both must be free
  PlaneExtent extent;      ///< contains both
  TravelWeights weights;
  int iterations = 3000;
  std::uint32_t seed = 0;
  std::vector<PlanarPose> guide;  ///< the first samples, in this order; may be empty
};

/// Where samples are drawn. The caller may change it during the search when a better route is found.
struct SampleFocus {
  std::vector<PlanarPose> route;  ///< half of the samples are near this route; may be empty
  double cost = 0.0;  ///< cost of the best solution; bounds the samples by their distances to start and goal; 0 if none
};

/// Statistics of a search.
struct RrtStarReport {
  int iterations = 0, states = 0;
};

/// Called with each better path (yaws unwrapped) and its cost; it may change the focus.
using RouteFound = std::function<void(const std::vector<PlanarPose>& route, double cost)>;

/// RRT* of OMPL over SE(2) (Karaman and Frazzoli, IJRR 30(7), 2011) with TravelCost as its objective. Deterministic:
/// samples come from a separate generator and neighbours from cells of the plane. OMPL's output is suppressed
/// meanwhile.
RrtStarReport SearchRrtStar(PoseCheck& check, const RrtStarProblem& problem, SampleFocus& focus,
                            const RouteFound& on_route);

}  // namespace gaitwright
