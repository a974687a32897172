// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/base/result.h"
#include "planning/footsteps/footstep_graph.h"

namespace gaitwright {

/// A search without a solution.
struct Blockage {
  int farthest = -1;  ///< checked stance with the most progress; -1 if none was checked
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

/// Failure with the place and the reason why the search could not continue beyond its farthest stance. The reasons are
/// checked in this order, where the feet would step next: a gap too wide, a step too high or ground too steep for the
/// robot (limits found by trial, see StepLimits); an obstacle on the body's path; the most frequent reason for failed
/// footholds and stances.
Failure ExplainBlockage(const SearchScene& scene, FootstepGraph& graph, const Blockage& blockage);

}  // namespace gaitwright
