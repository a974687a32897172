// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "optimisation/search/plan_walk.h"

namespace gaitwright {

/// The motion with its audit, or the reason why there is no motion.
/// @param only_sound  a motion that violates limits is returned without an audit, because it is not sound anyway.
Result<PlannedWalk> Audited(const RobotModel& model, Result<PlannedMotion> motion, const AuditOptions& options = {},
                            bool only_sound = false);

}  // namespace gaitwright
