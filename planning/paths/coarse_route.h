// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "planning/paths/pose_check.h"
#include "planning/paths/travel_cost.h"

namespace gaitwright {

/// Rectangle of the plane that is searched.
using PlaneExtent = Eigen::AlignedBox2d;

/// Problem of the grid search.
struct CoarseProblem {
  PlanarPose start, goal;  ///< both must be free
  PlaneExtent extent;      ///< contains both
  TravelWeights weights;
};

/// A path over a grid, with the first obstacle that it passes through.
struct CoarseRoute {
  std::vector<PlanarPose> poses;       ///< from start to goal; headings are multiples of 45 degrees, except at the goal
  std::optional<Hindrance> hindrance;  ///< the first one on the path, if any
  bool complete = false;               ///< true if the path passes through no obstacle
};

/// The cheapest path over a grid with cells of a quarter of the leg's length and eight headings. It is a guide for a
/// finer search, because only the grid's poses are checked. If it is much longer than the straight line, a grid of a
/// tenth of the leg's length is searched too, which finds narrower openings; its path is used if it is clearly cheaper.
/// If no path exists, the result passes through obstacles for the shortest possible distance and reports the first one.
/// A* (Hart, Nilsson and Raphael, 1968).
CoarseRoute FindCoarseRoute(PoseCheck& check, const CoarseProblem& problem);

}  // namespace gaitwright
