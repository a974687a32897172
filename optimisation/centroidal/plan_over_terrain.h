// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "optimisation/centroidal/choose_footholds.h"
#include "optimisation/centroidal/plan_rigid_body.h"

namespace gaitwright {

/// Tuning
///   a motion is refused although other footholds allow one   raise most_steps, near_m
///   infeasible motions take too long                         lower most_steps
struct PatchSearchOptions {
  double near_m = 0.6;
  double better = 0.95;
  int screening_steps = 30;
  int most_steps = 150;

  OptionFields Fields();
};

/// A motion with its footholds.
struct PlanOverPatches {
  ChosenFootholds choice;
  RigidBodyPlan plan;
  int choices = 0;  ///< number of patch choices that were planned
};

/// Stances that change to another patch together.
struct PatchChange {
  double rank = 0.0;  ///< distance of the patch divided by the violation
  std::vector<std::size_t> stances = {};
  int patch = 0;
};

/// For a plan with violated constraints: changes of violated stances (region, reach or friction) to other patches
/// within `near_m`, alone or together with stances of the same time; the lowest rank first.
std::vector<PatchChange> PatchChanges(const Terrain& terrain, const PlanOverPatches& plan, double edge_margin_m,
                                      double near_m);

/// The footholds of a plan with such a change, and a path fitted to them.
ChosenFootholds Changed(const Terrain& terrain, const PlanOverPatches& plan, const PatchChange& change,
                        double edge_margin_m);

/// Chooses footholds and plans the motion over them. If constraints stay violated, the worst stances change to other
/// patches nearby, one at a time or together with stances of the same time, as long as the sum of violations falls.
/// Failures as of ChooseFootholds and PlanRigidBody, for the best patches found.
/// @param last  if given: receives the best patches and the last state of their plan.
Result<PlanOverPatches> PlanOverTerrain(const Terrain& terrain, const RigidBodyProblem& problem,
                                        const ChooseFootholdsOptions& choosing = {},
                                        const RigidBodyOptions& planning = {}, const PatchSearchOptions& search = {},
                                        PlanOverPatches* last = nullptr);

}  // namespace gaitwright
