// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "planning/paths/coarse_way.h"
#include "planning/paths/pose_check.h"
#include "planning/paths/travel_cost.h"

namespace gaitwright {

/// A way to be found among free poses.
struct RrtStarProblem {
  PlanarPose start, goal;  ///< both free
  PlaneExtent extent;      ///< holds both
  TravelWeights weights;
  int iterations = 3000;
  std::uint32_t seed = 0;
  std::vector<PlanarPose> guide;  ///< the first samples, in this order; may be empty
};

/// Where samples are drawn. What finds a better route changes it while the search goes on.
struct SampleFocus {
  std::vector<PlanarPose> route;  ///< half of the samples are near to it; empty for none
  double cost =
      0.0;  ///< of the best solution, which bounds the samples by their distances to start and goal; 0 for none
};

/// Statistics of a search.
struct RrtStarReport {
  int iterations = 0, states = 0;
};

/// Called with each better way, yaws unwrapped, and its cost; it may change the focus.
using WayFound = std::function<void(const std::vector<PlanarPose>& way, double cost)>;

/// RRT* of OMPL over SE(2) (Karaman and Frazzoli, IJRR 30(7), 2011) with TravelCost as its objective. A pure function
/// of its arguments: samples come from a generator of its own and neighbours from cells of the plane; OMPL is kept
/// silent meanwhile.
RrtStarReport SearchRrtStar(PoseCheck& check, const RrtStarProblem& problem, SampleFocus& focus,
                            const WayFound& on_way);

}  // namespace gaitwright
