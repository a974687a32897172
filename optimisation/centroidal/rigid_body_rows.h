// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "optimisation/centroidal/plan_rigid_body.h"
#include "optimisation/centroidal/rigid_body_unknowns.h"
#include "optimisation/numerics/constrained_problem.h"

namespace gaitwright {

/// For each stance, the time at which its foot is farthest out of reach at 1 kHz, if by more than `tolerance_m`.
std::vector<MissedReach> MissedReaches(const RigidBodyProblem& problem, const RigidBodyMotion& motion,
                                       double tolerance_m);

/// The problem as rows over its unknowns, without an initial guess; reach is also checked at missed times.
ConstrainedProblem RigidBodyRows(const RigidBodyProblem& problem, const RigidBodyUnknowns& unknowns,
                                 const RigidBodyOptions& options, const std::vector<MissedReach>& missed);

/// Initial unknowns: along the problem's path, or above its footholds, with the weight shared by all stance feet.
VectorX GuessRigidBody(const RigidBodyProblem& problem, const RigidBodyUnknowns& unknowns);

}  // namespace gaitwright
