// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/centroidal/plan_over_terrain.h"

#include <fmt/format.h>

#include <optional>
#include <utility>

namespace gaitwright {
namespace {

/// Plans over one choice of patches after the other, until one is feasible.
class PatchSearch {
 public:
  PatchSearch(const RigidBodyOptions& planning, const PatchSearchOptions& search, PatchChoices choices)
      : planning_(planning), search_(search), choices_(std::move(choices)) {}

  Result<PlanOverPatches> Run(ChosenFootholds choice) {
    best_.choice = std::move(choice);
    Result<RigidBodyPlan> plan = Try(best_);
    planning_.early_check = search_.early_check_steps;
    if (!plan) choices_.Offer(best_);
    while (!plan && steps_ < search_.most_steps) {
      std::optional<ChosenFootholds> changed = choices_.Next();
      if (!changed) break;
      PlanOverPatches other{std::move(*changed), {}};
      Result<RigidBodyPlan> planned = Try(other);
      if (!planned && !choices_.Offer(other)) continue;
      best_ = std::move(other);
      plan = std::move(planned);
    }
    best_.choices = planned_;
    best_.plan.summary.iterations = steps_;
    if (!plan) {
      Failure failure = plan.failure();
      if (planned_ > 1) failure.message += fmt::format("; this is the best of {} choices of patches", planned_);
      return failure;
    }
    return best_;
  }

  const PlanOverPatches& best() const { return best_; }

 private:
  Result<RigidBodyPlan> Try(PlanOverPatches& tried) {
    ++planned_;
    Result<RigidBodyPlan> plan = PlanRigidBody(tried.choice.problem, planning_, &tried.plan);
    steps_ += tried.plan.summary.iterations;
    return plan;
  }

  RigidBodyOptions planning_;
  const PatchSearchOptions& search_;
  PatchChoices choices_;
  PlanOverPatches best_;
  int steps_ = 0, planned_ = 0;
};

}  // namespace

Result<PlanOverPatches> PlanOverChoice(const Terrain& terrain, ChosenFootholds choice, PatchRules rules,
                                       const RigidBodyOptions& planning, const PatchSearchOptions& search,
                                       PlanOverPatches* last) {
  PatchSearchOptions checked = search;
  CheckOptions(checked.Fields());
  PatchSearch patches(planning, search, PatchChoices(terrain, std::move(rules), search));
  Result<PlanOverPatches> plan = patches.Run(std::move(choice));
  if (last != nullptr) *last = patches.best();
  return plan;
}

Result<PlanOverPatches> PlanOverTerrain(const Terrain& terrain, const RigidBodyProblem& problem,
                                        const ChooseFootholdsOptions& choosing, const RigidBodyOptions& planning,
                                        const PatchSearchOptions& search, PlanOverPatches* last) {
  RigidBodyOptions planning_checked = planning;
  PatchSearchOptions search_checked = search;
  CheckOptions(Joined({planning_checked.Fields(), search_checked.Fields()}));
  Result<ChosenFootholds> choice = ChooseFootholds(terrain, problem, choosing);
  if (!choice) {
    if (last != nullptr) *last = {};
    return choice.failure();
  }
  return PlanOverChoice(terrain, std::move(*choice), RulesOf(terrain, choosing.edge_margin_m), planning, search, last);
}

}  // namespace gaitwright
