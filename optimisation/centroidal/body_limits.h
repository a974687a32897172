// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "kinematics/base/result.h"
#include "optimisation/centroidal/rigid_body_problem.h"

namespace gaitwright {

/// What no forces within a problem's limits can do, from its times and sizes alone, before anything is solved. What
/// must hold of every motion, with R the farthest that a leg reaches from the centre of mass and F what all feet of a
/// support push at most:
///   flight    of a duration t takes an upward speed of g t / 2 + (lowest landing - highest lift-off) / t. Legs give
///             v^2 = u^2 + 2 (F / m - g) s over their stroke s, and v = u + (F / m - g) t over the support's time, u
///             the upward speed with which it began, that of the flight before less g t;
///   friction  on level ground: a body from rest to rest in a time T goes mu T (g T / 4 + v) far at most, v its
///             greatest upward speed.
/// @param friction_use  the share of the ground's friction that the stances have; messages are of the ground's.
/// @return kInfeasible `flight_too_long`, `too_little_friction` with the numbers, and what would do; nothing where they
/// hold.  @throws InvalidArgument as CheckRigidBodyProblem.
std::optional<Failure> WhyBeyondLegs(const RigidBodyProblem& problem, double friction_use = 1.0);

}  // namespace gaitwright
