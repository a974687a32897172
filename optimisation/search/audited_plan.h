// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "optimisation/search/plan_walk.h"

namespace gaitwright {

/// The motion with its audit, or why there is neither.
/// @param only_sound  a motion that is past limits is given without an audit, since it is not sound anyway
Result<PlannedWalk> Audited(const RobotModel& model, Result<PlannedMotion> motion, const AuditOptions& options = {},
                            bool only_sound = false);

}  // namespace gaitwright
