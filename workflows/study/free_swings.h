// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "optimisation/centroidal/rigid_body_motion.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// Swings of a plan as unknowns of its rigid-body problem, so that they are planned together with the body. Their
/// control points are the initial guess. Planes separate them from the solids under nearby patches, one plane between
/// each pair of checked fractions.
/// @param problem_foot  index of the problem's foot, by the robot's foot.
std::vector<RigidSwing> FreeSwingsOf(const Terrain& ground, const RigidBodyProblem& problem, const MotionPlan& plan,
                                     const std::vector<int>& problem_foot);

/// The free swings of a problem as in a motion, with planes at their present positions.
std::vector<RigidSwing> FreeSwingsOf(const Terrain& ground, const RigidBodyProblem& problem,
                                     const RigidBodyMotion& motion);

/// Replaces the swings of a problem, and their control points at the end of the numbers of its motion.
void TakeSwings(const std::vector<RigidSwing>& swings, RigidBodyProblem& problem, VectorX& numbers);

}  // namespace gaitwright
