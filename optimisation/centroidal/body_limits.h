// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "kinematics/base/result.h"
#include "optimisation/centroidal/rigid_body_problem.h"

namespace gaitwright {

/// Necessary conditions that follow from the times and sizes of a problem, checked before solving. R is the largest
/// reach of a leg from the centre of mass, F the largest total force of a support:
///   flight    of a duration t needs an upward speed of g t / 2 + (lowest landing - highest lift-off) / t. Legs give
///             v^2 = u^2 + 2 (F / m - g) s over their stroke s, and v = u + (F / m - g) t over the support's time, u
///             the upward speed at its start, equal to that of the previous flight minus g t;
///   friction  on level ground: a body from rest to rest in a time T moves at most mu T (g T / 4 + v), v its
///             largest upward speed.
/// @param friction_use  the share of the ground's friction that the stances use; messages name the ground's friction.
/// @return kInfeasible `flight_too_long`, `too_little_friction` with the values and hints; nothing if the conditions
/// hold.  @throws InvalidArgument as CheckRigidBodyProblem does.
std::optional<Failure> ReasonBeyondLegs(const RigidBodyProblem& problem, double friction_use = 1.0);

}  // namespace gaitwright
