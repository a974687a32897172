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
///   the way is refused although there is one           raise max_trials, lower spacing_s
struct ChooseFootholdsOptions {
  double edge_margin_m = 0.01;
  double spacing_s = 0.1;
  double misfit_m = 0.005;
  double hopeless_m = 0.05;
  int max_trials = 24;

  OptionFields Fields();
};

/// Footholds for the stances of a rigid body and how well it could reach them.
struct ChosenFootholds {
  RigidBodyProblem problem;  ///< as given, with a way, and a frame, a region and a friction for each stance
  std::vector<int> patches;  ///< of each stance; -1 where it is held
  double misfit_m = 0.0;     ///< farthest that a foot is out of its workspace on the best way found; 0 if none
  int trials = 0;
};

/// Puts a stance on a patch, as near as it can be to a place, `edge_margin_m` from the edges of the patch and of those
/// above it. @return false where there is no room, with nothing changed.
bool PutOnPatch(const Terrain& terrain, int patch, const Vector3& p_W, double edge_margin_m, RigidStance& stance);

/// Chooses for each stance that is not held the patch that it stands on and a place there to start from. A way of the
/// body (body_way.h) and the footholds are fitted to each other, and each stance takes the patch that suits it best;
/// where feet stay out of reach, other patches are tried for them, one at a time. Failure kInfeasible:
///   `no_patches`         where there is no room to stand; the ground is taken by its patches alone
///   `goal_out_of_reach`  names a foot that reaches no patch from where the body is to end
///   `goal_not_held`      says how much friction would hold a body that is to be at rest at the goal, where forces at
///                        all places that its feet reach from there add up to no upright one with what there is
///   `out_of_reach`       names the foot that stays out of its workspace by more than hopeless_m, whatever the forces,
///                        when, and how far the body goes while it stands
/// @throws InvalidArgument as CheckRigidBodyProblem.
Result<ChosenFootholds> ChooseFootholds(const Terrain& terrain, const RigidBodyProblem& problem,
                                        const ChooseFootholdsOptions& options = {});

}  // namespace gaitwright
