// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/base/result.h"
#include "planning/footsteps/footstep_graph.h"

namespace gaitwright {

/// Why the search could not go on beyond the stance of the most progress, as a failure that names the place and the
/// reason: a gap, a step, a slope or an obstacle on the way of the feet, or what every step from there met with.
Failure ExplainBlockage(const RobotModel& model, const GroundIndex& ground, const FootstepQuery& query,
                        FootstepGraph& graph, int farthest, const FootstepSearchOptions& options);

}  // namespace gaitwright
