// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "optimisation/centroidal/plan_rigid_body.h"
#include "optimisation/centroidal/rigid_body_unknowns.h"
#include "optimisation/numerics/constrained_problem.h"

namespace gaitwright {

/// Where feet are farthest out of reach by more than `tolerance_m` at 1 kHz, each stance's worst.
std::vector<MissedReach> MissedReaches(const RigidBodyProblem& problem, const RigidBodyMotion& motion,
                                       double tolerance_m);

/// The problem as rows over its unknowns, without a start; reach is looked at where it was missed too.
ConstrainedProblem RigidBodyRows(const RigidBodyProblem& problem, const RigidBodyUnknowns& unknowns,
                                 const RigidBodyOptions& options, const std::vector<MissedReach>& missed);

/// Unknowns to begin with: along the problem's way, or over its footholds, the weight shared by all that carry.
VectorX GuessRigidBody(const RigidBodyProblem& problem, const RigidBodyUnknowns& unknowns);

}  // namespace gaitwright
