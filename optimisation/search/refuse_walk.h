// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "optimisation/pipeline/limit_violation.h"
#include "optimisation/search/plan_walk.h"

namespace gaitwright {

/// Violations of the robot's limits, the worst relative to its limit first: position, speed and torque of joints, reach
/// of legs, self-collision. Empty if all limits are kept.
std::vector<Violation> BrokenLimits(const AuditReport& audit);

/// All violations for which a plan is refused: limits, worst first, then other checks in the audit's order.
std::vector<Violation> Forbidding(const AuditReport& audit);

/// True for failures that a slower walk may avoid. False if the gait, the robot's structure or the ground is the
/// reason.
bool IsTooMuch(const Failure& failure);

/// Whether a plan is good enough to be returned.
bool IsSound(const Result<PlannedWalk>& planned);

/// Failure for a plan that is not sound: the robot's worst limit, or otherwise the first of the other checks.
Failure ReasonForbidden(const PlannedWalk& planned);

/// Code of that failure, or of the planner's own failure.
FailureCode ReasonRefused(const Result<PlannedWalk>& planned);

/// One sentence, without a full stop, for a violation of a limit: joint, link or foot, value, limit and their
/// difference. For other checks: what is missing.
std::string LimitText(const Violation& violation);

/// Suggestion to accept a plan that fails its audit.
Suggestion AllowLimits();

}  // namespace gaitwright
