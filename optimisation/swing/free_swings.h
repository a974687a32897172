// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "optimisation/centroidal/rigid_body_motion.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// Swings as unknowns of a rigid body's problem, to be planned together with its motion. Their control points are the
/// initial guess. Planes separate them from all that is solid under patches near them, each from one checked fraction
/// to the next.
/// @param problem_foot  foot of the problem, by the swing's foot.
/// @param start_s       time of the swings at which the problem begins.
std::vector<RigidSwing> FreeSwingsOf(const Terrain& ground, const RigidBodyProblem& problem,
                                     const std::vector<SwingTrajectory>& swings, const std::vector<int>& problem_foot,
                                     double start_s = 0.0);

/// The free swings of a problem as they are in a motion, with planes beside them there.
std::vector<RigidSwing> FreeSwingsOf(const Terrain& ground, const RigidBodyProblem& problem,
                                     const RigidBodyMotion& motion);

/// A swing of a problem as it is in a motion, which begins at start_s; it starts where the foot has rolled to.
SwingTrajectory SwingOf(const RigidBodyProblem& problem, const RigidBodyMotion& motion, std::size_t swing,
                        double start_s = 0.0);

/// Takes swings into a problem instead of its own, and their control points into the numbers of a motion of it, which
/// end with those of swings.
void TakeSwings(const std::vector<RigidSwing>& swings, RigidBodyProblem& problem, VectorX& numbers);

}  // namespace gaitwright
