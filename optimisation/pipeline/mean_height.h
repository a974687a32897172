// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// Mean height of a centre of mass above the plane through the feet [m]: stance feet at their footholds, swing feet
/// interpolated between theirs.
/// @param footsteps  sorted (SortFootholds).
/// @throws InvalidArgument for a motion without samples, or a foot without footholds.
double MeanHeightOverFeet(const CentroidalTrajectory& motion, const FootstepPlan& footsteps, int num_feet);

}  // namespace gaitwright
