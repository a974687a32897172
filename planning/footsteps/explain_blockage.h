// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/base/result.h"
#include "planning/footsteps/footstep_graph.h"

namespace gaitwright {

/// A search that found nothing.
struct Blockage {
  int farthest = -1;  ///< checked stance with the most progress; -1 for none
  bool out_of_budget = false;
};

/// Inputs of a search.
struct SearchScene {
  const RobotModel& model;
  const GroundIndex& ground;
  const FootstepQuery& query;
  const FootholdChecker& checker;
  const FootstepSearchOptions& options;
};

/// Why the search could not go on beyond its farthest stance, as a failure that names the place and the reason. Looked
/// for are, in this order and where the feet would go next: a gap wider, a step higher or ground steeper than the robot
/// can do (measured by trial, see StepLimits), an obstacle in the body's way, and what most footholds and stances there
/// fail by.
Failure ExplainBlockage(const SearchScene& scene, FootstepGraph& graph, const Blockage& blockage);

}  // namespace gaitwright
