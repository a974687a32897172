// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "optimisation/centroidal/gait_phases.h"
#include "optimisation/centroidal/plan_rigid_body.h"

namespace gaitwright {

/// Variables of a motion for the same stances at other times: its nodes and missed reaches move with them.
RigidBodyNumbers Retimed(RigidBodyNumbers numbers, const TimeMap& map);

/// Derivative of the optimal cost with respect to the duration of each phase (SwitchTimes), with all later phases
/// shifted [1/s]. By the envelope theorem it is the derivative of
///   |r|^2 + sum_i multiplier_i (row_i - its active bound)
/// for constant unknowns and multipliers, here by differences. If constraints stay violated, it is the derivative of
/// the cost plus the penalty. Nocedal and Wright, Numerical Optimization, 2006, section 12.3.
/// @param numbers  of the optimal motion of the problem.
/// @throws InvalidArgument for numbers that do not fit the problem, and for a problem that is not IsRetimable.
VectorX CostByDurations(const RigidBodyProblem& problem, const RigidBodyOptions& options,
                        const RigidBodyNumbers& numbers);

}  // namespace gaitwright
