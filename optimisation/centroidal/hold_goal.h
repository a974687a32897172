// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "optimisation/centroidal/rigid_body_problem.h"
#include "planning/plan/terrain.h"

namespace gaitwright {

/// The smallest friction, up to `most`, with which contact forces on ground with these normals can add up to a vertical
/// force, as needed at rest; infinite if `most` is not enough. On parallel slopes it is the tangent of the smallest
/// slope; between facing walls or on both sides of a ridge it is less.
double LeastHoldingFriction(const std::vector<Vector3>& normals_W, double most = 10.0);

/// Ground of the final stance feet, for the body at its goal.
struct GoalGround {
  int foot = -1;                 ///< the foot farthest out of its workspace on every patch; -1 if all reach ground
  double out_of_reach_m = 0.0;   ///< by how much
  double friction = 0.0;         ///< largest friction of the ground within reach
  double needed_friction = 0.0;  ///< friction that holds the body at rest there; 0 if it need not be at rest
};

/// Checks each patch for each foot, and all combinations of feet and patches. @param tolerance_m  distance out of reach
/// up to which a foothold counts as reached.
GoalGround LookAtGoal(const Terrain& terrain, const RigidBodyProblem& problem, double edge_margin_m,
                      double tolerance_m);

}  // namespace gaitwright
