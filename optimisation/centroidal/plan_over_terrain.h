// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "optimisation/centroidal/choose_footholds.h"
#include "optimisation/centroidal/plan_rigid_body.h"

namespace gaitwright {

/// Tuning
///   a motion is refused although other footholds allow one   raise most_steps, near_m
///   too long is spent on what has no motion                  lower most_steps
struct PatchSearchOptions {
  double near_m = 0.6;
  double better = 0.95;
  int screening_steps = 30;
  int most_steps = 150;

  OptionFields Fields();
};

/// A motion with the footholds that it was found for.
struct PlanOverPatches {
  ChosenFootholds choice;
  RigidBodyPlan plan;
  int choices = 0;  ///< of patches that were planned for
};

/// Stances that take another patch together.
struct PatchChange {
  double rank = 0.0;  ///< how far away that is over the trouble that they are in
  std::vector<std::size_t> stances = {};
  int patch = 0;
};

/// For a plan with laws unmet: what stances in trouble, out of region or reach or beyond friction, could take other
/// patches within `near_m`, alone or with those that last as long; the lowest rank first.
std::vector<PatchChange> PatchChanges(const Terrain& terrain, const PlanOverPatches& plan, double edge_margin_m,
                                      double near_m);

/// The footholds of a plan with such a change, and a way fitted to them.
ChosenFootholds Changed(const Terrain& terrain, const PlanOverPatches& plan, const PatchChange& change,
                        double edge_margin_m);

/// Chooses footholds and plans the motion over them. Where laws stay unmet, stances that are worst off take other
/// patches near to where their feet would be, one at a time or with those that last as long, as long as the sum of what
/// is violated falls by that. Failures as those of ChooseFootholds and PlanRigidBody, of the best patches found.
/// @param last  if given: the best patches and where their plan stood.
Result<PlanOverPatches> PlanOverTerrain(const Terrain& terrain, const RigidBodyProblem& problem,
                                        const ChooseFootholdsOptions& choosing = {},
                                        const RigidBodyOptions& planning = {}, const PatchSearchOptions& search = {},
                                        PlanOverPatches* last = nullptr);

}  // namespace gaitwright
