// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "planning/paths/pose_check.h"

namespace gaitwright {

/// Extent of the plane in which ways are looked for.
using PlaneExtent = Eigen::AlignedBox2d;

/// A way over a grid, and what had to be passed through for it.
struct CoarseWay {
  std::vector<PlanarPose> poses;       ///< facing along the way
  std::optional<Hindrance> hindrance;  ///< the first on the way, if it was let through any
  bool complete = false;               ///< it leads to the goal
};

/// The shortest way over a grid of a quarter of the leg's length, the body facing the way it goes: a guide for finer
/// search. Where there is none, it is made to pass what hinders it for as short as can be, and says what that is.
/// A* (Hart, Nilsson and Raphael, 1968) with eight neighbours.
CoarseWay FindCoarseWay(PoseCheck& check, const PlanarPose& start, const PlanarPose& goal, const PlaneExtent& extent);

}  // namespace gaitwright
