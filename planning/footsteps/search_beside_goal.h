// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "planning/footsteps/search_footsteps.h"

namespace gaitwright {

/// SearchFootsteps with ends within four times the goal tolerance. For rough ground without footholds near the goal but
/// with footholds a little beside it.
Result<FootstepSequence> SearchBesideGoal(const RobotModel& model, const Terrain& terrain, const FootstepQuery& query,
                                          const FootholdOptions& footholds, const FootstepSearchOptions& options);

}  // namespace gaitwright
