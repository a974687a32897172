// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "planning/paths/pose_check.h"
#include "planning/paths/travel_cost.h"

namespace gaitwright {

/// Extent of the plane in which ways are looked for.
using PlaneExtent = Eigen::AlignedBox2d;

/// A way to be found on a grid.
struct CoarseProblem {
  PlanarPose start, goal;  ///< both free
  PlaneExtent extent;      ///< holds both
  TravelWeights weights;
};

/// A way over a grid, and what had to be passed through for it.
struct CoarseWay {
  std::vector<PlanarPose> poses;       ///< from the start to the goal, facing one of eight ways but for the goal
  std::optional<Hindrance> hindrance;  ///< the first on the path, if it passes any
  bool complete = false;               ///< it passes none
};

/// The cheapest path over a grid of a quarter of the leg's length and eight headings: a guide for a finer search,
/// because only the grid's poses are checked. If it is much longer than the straight line, a path over a grid of a
/// tenth, which finds narrower openings, replaces it if it is clearly cheaper. If there is none, the path passes
/// obstacles for the shortest possible distance and reports the first one. A* (Hart, Nilsson and Raphael, 1968).
CoarseWay FindCoarseWay(PoseCheck& check, const CoarseProblem& problem);

}  // namespace gaitwright
