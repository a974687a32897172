// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "optimisation/centroidal/gait_phases.h"
#include "optimisation/centroidal/plan_rigid_body.h"

namespace gaitwright {

/// Numbers of a motion for the same stances at other times: its breaks, and where reach was missed, go with them.
RigidBodyNumbers Retimed(RigidBodyNumbers numbers, const TimeMap& map);

/// The slope of the least cost of a motion by the duration of each of its phases (SwitchTimes), all that comes later
/// moved with it [1/s]. By the envelope theorem it is that of
///   |r|^2 + sum_i multiplier_i (row_i - the end that it is held at)
/// while unknowns and multipliers stay what they are, here by differences. Where laws stay unmet it is the slope of
/// the cost and what is paid for their violation. Nocedal and Wright, Numerical Optimization, 2006, section 12.3.
/// @param numbers  of a motion of the problem that is the least costly one.
/// @throws InvalidArgument for numbers that do not fit the problem, and for one that is not IsRetimable.
VectorX CostByDurations(const RigidBodyProblem& problem, const RigidBodyOptions& options,
                        const RigidBodyNumbers& numbers);

}  // namespace gaitwright
