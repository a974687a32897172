// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "optimisation/centroidal/patch_choices.h"

namespace gaitwright {

/// Plans a motion over chosen footholds. If constraints stay violated, the worst stances change to other patches
/// nearby, one at a time or together with stances of the same time, as long as the sum of violations falls
/// (PatchChoices). Failures as of PlanRigidBody, for the best patches found.
/// @param last  if given: receives the best patches and the last state of their plan.
Result<PlanOverPatches> PlanOverChoice(const Terrain& terrain, ChosenFootholds choice, PatchRules rules,
                                       const RigidBodyOptions& planning = {}, const PatchSearchOptions& search = {},
                                       PlanOverPatches* last = nullptr);

/// Chooses footholds and plans the motion over them (PlanOverChoice). Failures as of ChooseFootholds and PlanRigidBody.
/// @param last  if given: receives the best patches and the last state of their plan.
Result<PlanOverPatches> PlanOverTerrain(const Terrain& terrain, const RigidBodyProblem& problem,
                                        const ChooseFootholdsOptions& choosing = {},
                                        const RigidBodyOptions& planning = {}, const PatchSearchOptions& search = {},
                                        PlanOverPatches* last = nullptr);

}  // namespace gaitwright
