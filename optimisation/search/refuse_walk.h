// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "optimisation/search/plan_walk.h"

namespace gaitwright {

/// What a plan breaks of what the robot can do, worst first in proportion to its limit: position, speed and torque of
/// joints, reach of legs, collisions of the robot with itself. Empty for a plan that keeps them all.
std::vector<Violation> BrokenLimits(const AuditReport& audit);

/// All that a plan breaks for which it is not given: limits, worst first, and then other laws in the audit's order.
std::vector<Violation> Forbidding(const AuditReport& audit);

/// Past limits by this much in all the audit may let a plan pass.
inline constexpr double kSlightExcess = 1e-5;

/// True for failures that a slower walk may not have: not what the gait, the robot's build or the ground forbids.
bool IsTooMuch(const Failure& failure);

/// Whether a plan is sound enough to be given.
bool IsSound(const Result<PlannedWalk>& planned);

/// Why a plan that is not sound is not given: the worst limit of the robot, or else the first of the other laws.
Failure WhyForbidden(const PlannedWalk& planned);

/// The code for which a plan that is not sound is refused.
FailureCode ReasonRefused(const Result<PlannedWalk>& planned);

/// One sentence without a full stop that names the joint, link or foot of a violation, its value, its limit and by how
/// much that is passed; of other laws than limits what is lacking.
std::string LimitText(const Violation& violation);

/// To give a plan all the same that fails its audit.
Suggestion AllowLimits();

}  // namespace gaitwright
