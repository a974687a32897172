// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "optimisation/centroidal/rigid_body_motion.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// Swings of a plan as unknowns of its rigid body's problem, to be planned along with its motion: their control points
/// are the first guess, and planes part them from all that is solid under patches near them, from each share at which
/// they are looked at to the next.
/// @param problem_foot  of the problem, by the robot's foot.
std::vector<RigidSwing> FreeSwingsOf(const Terrain& ground, const RigidBodyProblem& problem, const MotionPlan& plan,
                                     const std::vector<int>& problem_foot);

/// The free swings of a problem as they are in a motion, with planes beside them there.
std::vector<RigidSwing> FreeSwingsOf(const Terrain& ground, const RigidBodyProblem& problem,
                                     const RigidBodyMotion& motion);

/// Takes swings into a problem instead of its own, and their control points into the numbers of a motion of it, which
/// end with those of swings.
void TakeSwings(const std::vector<RigidSwing>& swings, RigidBodyProblem& problem, VectorX& numbers);

}  // namespace gaitwright
