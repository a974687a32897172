// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "kinematics/base/options.h"
#include "kinematics/base/result.h"
#include "optimisation/centroidal/rigid_body_problem.h"
#include "planning/plan/terrain.h"

namespace gaitwright {

/// Tuning
///   feet stand too near to edges                       raise edge_margin_m
///   the path is refused although one exists             raise max_trials, lower spacing_s
struct ChooseFootholdsOptions {
  double edge_margin_m = 0.01;
  double spacing_s = 0.1;
  double misfit_m = 0.005;
  double infeasible_m = 0.05;
  int max_trials = 24;

  OptionFields Fields();
};

/// Footholds for the stances of a rigid body, and how well it can reach them.
struct ChosenFootholds {
  RigidBodyProblem problem;  ///< as given, with a path, and a frame, a region and a friction for each stance
  std::vector<int> patches;  ///< of each stance; -1 if it is fixed
  double misfit_m = 0.0;     ///< largest distance of a foot out of its workspace on the best path found; 0 if none
  int trials = 0;
};

/// Puts a stance on a patch, as close as possible to a position, `edge_margin_m` from the edges of the patch and of
/// those above it. @return false if there is no room; then nothing changes.
bool PutOnPatch(const Terrain& terrain, int patch, const Vector3& p_W, double edge_margin_m, RigidStance& stance);

/// Chooses the patch of each free stance, and an initial position on it. A path of the body (body_trajectory.h) and the
/// footholds are fitted to each other, and each stance gets the patch of lowest cost; if feet stay out of reach, other
/// patches are tried for them, one at a time. Failure kInfeasible:
///   `no_patches`         if there is no room to stand; only patches of the ground are used
///   `goal_out_of_reach`  names a foot that reaches no patch from the body's goal
///   `goal_not_held`      names the friction that would hold the body at rest at the goal, if the available friction
///                        does not suffice at any place that its feet reach from there
///   `out_of_reach`       names the foot that stays out of its workspace by more than infeasible_m for any forces, the
///                        time, and the distance that the body moves during the stance
/// @throws InvalidArgument as CheckRigidBodyProblem does.
Result<ChosenFootholds> ChooseFootholds(const Terrain& terrain, const RigidBodyProblem& problem,
                                        const ChooseFootholdsOptions& options = {});

}  // namespace gaitwright
