// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/search/walk_evaluator.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "optimisation/pipeline/dynamic_motion.h"
#include "optimisation/search/audited_plan.h"
#include "optimisation/search/first_look.h"
#include "optimisation/search/pace.h"
#include "optimisation/search/refuse_walk.h"
#include "optimisation/search/start_of_walk.h"

namespace gaitwright {
namespace {

constexpr double kKnotStep_s = 0.02;  // motions without flight are slow enough
constexpr int kFewIterations = 30;    // of an optimised whole body, for starts and calm walks

/// The request for plans that only test feasibility: with twice the time step if a cycle has enough steps, and without
/// optimality.
WalkRequest Coarse(const WalkRequest& request, double cycle_s) {
  constexpr double kStepsOfCycle = 100.0;  // with fewer steps, peaks of joint speeds are missed
  constexpr double kCoarsest = 0.01;       // [s]
  WalkRequest coarse = request;
  coarse.motion.rigid_body.method = "interior-point";  // faster if no motion exists
  double& grid = coarse.motion.pipeline.grid_step_s;
  if (cycle_s >= 2.0 * grid * kStepsOfCycle) grid = std::max(grid, std::min(2.0 * grid, kCoarsest));
  return coarse;
}

Evaluation Refused(const Failure& failure) {
  Evaluation evaluation;
  evaluation.refusal = failure;
  evaluation.at_every_pace = !IsTooMuch(failure);
  evaluation.no_footholds = failure.code == FailureCode::kNoFootholds;
  evaluation.by_ground = failure.violation && failure.violation->law == Law::kZmpSupport;
  return evaluation;
}

Evaluation EvaluationOf(Result<PlannedWalk> planned) {
  if (!planned) return Refused(planned.failure());
  Evaluation evaluation;
  if (!IsSound(planned)) {
    evaluation.refusal = ReasonForbidden(*planned);
    evaluation.by_ground = BrokenLimits(planned->audit).empty();
  }
  evaluation.room = RoomOf(planned);
  evaluation.planned = std::make_shared<PlannedWalk>(std::move(*planned));
  return evaluation;
}

}  // namespace

WalkEvaluator::WalkEvaluator(const RobotModel& model, const Terrain& terrain, const WalkRequest& request,
                             SearchTrace* trace)
    : model_(model), terrain_(terrain), request_(request), trace_(trace), asked_(PaceValue(model, request.command)) {}

WalkCommand WalkEvaluator::CommandOf(const Candidate& candidate) const {
  return candidate.pace == asked_ ? request_.command : AtPace(model_, request_.command, candidate.pace);
}

Result<GaitCycles> WalkEvaluator::CyclesOf(const Candidate& candidate) const {
  const WalkCommand command = CommandOf(candidate);
  if (candidate.flight > 0.0) return FindCycles(model_, request_, command);
  const Result<Gait> slow = FindGait(model_, request_.gait, 0.0, request_.gait_options);
  if (!slow) return slow.failure();
  WalkRequest grounded = request_;
  grounded.gait_options.duty_factor = *std::max_element(slow->duty_factor.begin(), slow->duty_factor.end());
  return FindCycles(model_, grounded, command);
}

Gait WalkEvaluator::GaitOf(const Candidate& candidate, const GaitCycles& cycles) const {
  constexpr double kMost = 0.95;  // share of the cycle in stance, so that the feet have time to swing
  Gait gait = cycles.At(candidate.cycle);
  if (candidate.flight == 0.0 || candidate.flight == 1.0) return gait;
  for (double& duty : gait.duty_factor) duty = std::min(1.0 - candidate.flight * (1.0 - duty), kMost);
  return gait;
}

bool WalkEvaluator::Flies(const Candidate& candidate) {
  const Result<GaitCycles> cycles = CyclesOf(candidate);
  return cycles && IsDynamic(cycles->fitted, request_.motion.centre_of_mass);
}

Evaluation WalkEvaluator::Evaluate(const Candidate& candidate, Effort effort) {
  const Result<GaitCycles> cycles = CyclesOf(candidate);
  if (!cycles) return Refused(cycles.failure());
  const Gait gait = GaitOf(candidate, *cycles);
  const WalkCommand command = CommandOf(candidate);
  if (effort == Effort::kStart && candidate.finishes && IsShort(model_, command, gait)) effort = Effort::kWhole;
  const Key key{effort,
                PaceFlags(command),
                gait.cycle_s,
                gait.duty_factor.front(),
                candidate.other_footholds,
                candidate.finishes,
                candidate.heel_off_rad};
  if (const auto known = known_.find(key); known != known_.end()) return known->second;
  if (static_cast<int>(known_.size()) >= request_.search.max_plans) {
    return Refused(
        {FailureKind::kInfeasible,
         FailureCode::kSearchBudget,
         "PlanWalk",
         fmt::format("none of the {} candidates that were tried gave a plan that passes its audit",
                     request_.search.max_plans),
         {{"search.max_plans", 2.0 * request_.search.max_plans, Certainty::kEstimated, "a larger search.max_plans"}}});
  }
  Evaluation evaluation = Made(candidate, effort, *cycles, gait);
  Trace(candidate, effort, gait, evaluation);
  Evaluation& kept = known_[key] = evaluation;
  if (effort != Effort::kWhole || !evaluation.sound()) kept.planned.reset();
  return evaluation;
}

Evaluation WalkEvaluator::Made(const Candidate& candidate, Effort effort, const GaitCycles& cycles, const Gait& gait) {
  const WalkCommand command = CommandOf(candidate);
  const Key start{Effort::kStart,           PaceFlags(command),        gait.cycle_s,
                  gait.duty_factor.front(), candidate.other_footholds, candidate.finishes,
                  candidate.heel_off_rad};
  WalkRequest request = request_;
  request.motion = WithFootholds(request_.motion, candidate.other_footholds);
  if (candidate.finishes) {
    TrajectoryOptions& trajectory = request.motion.trajectory;
    trajectory.method = "whole-body";
    trajectory.knot_step_s = std::max(trajectory.knot_step_s, kKnotStep_s);
    trajectory.heel_off_rad = std::max(trajectory.heel_off_rad, candidate.heel_off_rad);
    if (effort == Effort::kStart || request_.own_pace)
      trajectory.max_iterations = std::min(trajectory.max_iterations, kFewIterations);
  }
  switch (effort) {
    case Effort::kStartLook:
      return Look(request, gait, command, false);
    case Effort::kFirstLook:
      return Look(request, gait, command, true);
    case Effort::kStart: {
      Evaluation evaluation = EvaluationOf(Start(request, gait, cycles.fitted.cycle_s, command));
      if (evaluation.sound()) com_height_m_[start] = evaluation.planned->motion.plan.centroidal.p_WC.front().z();
      return evaluation;
    }
    case Effort::kWhole:
      break;
  }
  // Try first the body height for which the start is sound.
  if (const auto height = com_height_m_.find(start); height != com_height_m_.end()) {
    WalkRequest at_height = request;
    at_height.motion.pipeline.com_height_m = height->second;
    Result<PlannedWalk> planned = Whole(at_height, gait, command, true);
    if (planned && planned->motion.limit_violation < kSlightViolation) return EvaluationOf(std::move(planned));
  }
  return EvaluationOf(Whole(request, gait, command, candidate != Candidate{asked_}));
}

Evaluation WalkEvaluator::Look(const WalkRequest& request, const Gait& gait, const WalkCommand& command,
                               bool whole) const {
  const FirstLook look = LookAt(model_, terrain_, request, gait, command, whole);
  Evaluation evaluation;
  evaluation.refusal = look.refusal;
  evaluation.ease = look.ease;
  evaluation.solved = look.solved;
  return evaluation;
}

Result<PlannedWalk> WalkEvaluator::Whole(const WalkRequest& request, const Gait& gait, const WalkCommand& command,
                                         bool only_sound) const {
  return Audited(model_, PlanMotion(model_, terrain_, gait, command, request.motion), request.motion, {}, only_sound);
}

/// Uses twice the time step if a cycle of `fitted_s` has enough steps.
Result<PlannedWalk> WalkEvaluator::Start(const WalkRequest& request, const Gait& gait, double fitted_s,
                                         const WalkCommand& command) const {
  AuditOptions seldom;
  seldom.rate_hz *= 0.5;
  const WalkRequest coarse = Coarse(request, fitted_s);
  return Audited(model_, PlanMotion(model_, terrain_, gait, StartOfWalk(model_, command, gait), coarse.motion),
                 coarse.motion, seldom, true);
}

void WalkEvaluator::Trace(const Candidate& candidate, Effort effort, const Gait& gait, const Evaluation& evaluation) {
  if (trace_ == nullptr) return;
  const WalkCommand command = CommandOf(candidate);
  const Pace pace = PaceOf(command);
  const bool free = MayMoveFeet(request_.motion, terrain_) && IsDynamic(gait, request_.motion.centre_of_mass) &&
                    WithFootholds(request_.motion, candidate.other_footholds).footholds == "free";
  const bool finishes = candidate.finishes || request_.motion.trajectory.finishes_all();
  const double heel_off_rad = std::max(request_.motion.trajectory.heel_off_rad, candidate.heel_off_rad);
  trace_->push_back({effort, PaceFlag(pace), PaceValue(model_, command), PaceUnit(pace), gait.cycle_s,
                     evaluation.refusal ? std::optional(evaluation.refusal->code) : std::nullopt, free, finishes,
                     finishes ? heel_off_rad : 0.0});
}

}  // namespace gaitwright
