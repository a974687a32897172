// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/search/walk_evaluator.h"

#include <algorithm>

#include "optimisation/search/refuse_walk.h"
#include "optimisation/search/slower_pace.h"

namespace gaitwright {
namespace {

/// The request for plans that only tell whether there are any: on a grid twice as coarse where a cycle has steps
/// enough, and no matter how good.
WalkRequest Coarse(const WalkRequest& request, double cycle_s) {
  constexpr double kStepsOfCycle = 100.0, kCoarsest = 0.01;
  WalkRequest coarse = request;
  coarse.motion.rigid_body.method = "interior-point";  // which knows sooner where there is none
  double& grid = coarse.motion.pipeline.grid_step_s;
  if (cycle_s >= 2.0 * grid * kStepsOfCycle) grid = std::max(grid, std::min(2.0 * grid, kCoarsest));
  return coarse;
}

}  // namespace

FirstLook WalkEvaluator::Look(const Gait& gait, const WalkCommand& command, bool whole) {
  FirstLook look = LookAt(model_, terrain_, request_, gait, command, whole);
  Add(TriedPlan::Extent::kFirstLook, gait, command,
      look.refusal ? std::optional(look.refusal->code) : std::optional<FailureCode>());
  return look;
}

Result<PlannedWalk> WalkEvaluator::PlanAndAudit(TriedPlan::Extent extent, const WalkRequest& request, const Gait& gait,
                                                const WalkCommand& command, const AuditOptions& options,
                                                bool only_passing) {
  const auto evaluate = [&]() -> Result<PlannedWalk> {
    Result<PlannedMotion> motion = PlanMotion(model_, terrain_, gait, command, request.motion);
    if (!motion) return motion.failure();
    PlannedWalk planned;
    planned.motion = std::move(*motion);
    if (planned.motion.limit_excess >= kSlightExcess && only_passing) return planned;
    const Result<AuditReport> audit = Audit(model_, planned.motion.plan, options);
    if (!audit) return audit.failure();
    planned.audit = *audit;
    return planned;
  };
  Result<PlannedWalk> planned = evaluate();
  if (trace_ != nullptr) {
    Add(extent, gait, command, IsSound(planned) ? std::optional<FailureCode>() : std::optional(ReasonRefused(planned)));
  }
  return planned;
}

Result<PlannedWalk> WalkEvaluator::Whole(const Gait& gait, const WalkCommand& command, bool only_passing) {
  return PlanAndAudit(TriedPlan::Extent::kWhole, request_, gait, command, {}, only_passing);
}

Result<PlannedWalk> WalkEvaluator::WholeAt(double height_m, const Gait& gait, const WalkCommand& command) {
  WalkRequest at_height = request_;
  at_height.motion.pipeline.com_height_m = height_m;
  Result<PlannedWalk> planned = PlanAndAudit(TriedPlan::Extent::kWhole, at_height, gait, command, {}, true);
  const bool keeps_limits = planned && planned->motion.limit_excess < kSlightExcess;
  return keeps_limits ? planned : Whole(gait, command, true);
}

double WalkEvaluator::Start(const Gait& gait, double fitted_s, const WalkCommand& command) {
  const auto asked = std::make_pair(PaceFlags(command), gait.cycle_s);
  const auto known = starts_.find(asked);
  if (known != starts_.end()) return known->second;
  AuditOptions seldom;
  seldom.rate_hz *= 0.5;
  const Result<PlannedWalk> planned = PlanAndAudit(TriedPlan::Extent::kStart, Coarse(request_, fitted_s), gait,
                                                   Shortened(model_, command, gait), seldom, true);
  const double height = IsSound(planned) ? planned->motion.plan.centroidal.p_WC.front().z() : 0.0;
  starts_[asked] = height;
  return height;
}

void WalkEvaluator::Add(TriedPlan::Extent extent, const Gait& gait, const WalkCommand& command,
                        std::optional<FailureCode> refused) {
  if (trace_ == nullptr) return;
  const Pace pace = PaceOf(command);
  trace_->push_back({extent, PaceFlag(pace), PaceValue(model_, command), PaceUnit(pace), gait.cycle_s, refused});
}

}  // namespace gaitwright
