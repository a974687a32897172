// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "optimisation/centroidal/rigid_body_problem.h"
#include "planning/plan/terrain.h"

namespace gaitwright {

/// The least friction, up to `most`, with which forces at contacts on ground of these normals add up to one that is
/// straight up, as a body at rest needs; infinite where that does not do. On ground that all slopes the same way it is
/// the tangent of the least slope; between walls that face each other, or astride a ridge, less does.
double LeastHoldingFriction(const std::vector<Vector3>& normals_W, double most = 10.0);

/// What the feet that are on the ground at the end find there, with the body where it is to be.
struct GoalGround {
  int foot = -1;                ///< that is farthest out of its workspace wherever it stands; -1 where all reach ground
  double out_of_reach_m = 0.0;  ///< by how much
  double friction = 0.0;        ///< the greatest of the ground within reach
  double needed_friction = 0.0;  ///< that holds the body at rest there; 0 where it is not to be at rest
};

/// Looks at each patch for each foot, and at all ways of standing one foot on one patch. @param tolerance_m  how far
/// out of reach a foothold may be and count as reached.
GoalGround LookAtGoal(const Terrain& terrain, const RigidBodyProblem& problem, double edge_margin_m,
                      double tolerance_m);

}  // namespace gaitwright
