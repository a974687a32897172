// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/pipeline/refine_motion.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "optimisation/swing/free_swings.h"

namespace gaitwright {
namespace {

/// Whether all options are in their ranges, which refinement may leave.
bool InRange(RigidBodyOptions options) {
  try {
    CheckOptions(options.Fields());
  } catch (const InvalidArgument&) {
    return false;
  }
  return true;
}

/// One round after another.
class Refiner {
 public:
  Refiner(const Terrain& ground, const PlanOverPatches& motion, RigidBodyOptions options, const RefineRules& rules)
      : ground_(ground),
        options_(std::move(options)),
        rules_(rules),
        at_(motion),
        choices_(ground, rules.patches, rules.search) {
    result_.motion = motion;
  }

  /// Has the attempt checked if it satisfies its constraints. @return why that cannot be.
  std::optional<Failure> Check(const MotionJudge& judge) {
    if (!feasible_) {
      swings_ = FreeSwingsOf(ground_, at_.choice.problem, at_.plan.motion);
      stray_m_ = 0.0;
      return std::nullopt;
    }
    Result<MotionVerdict> verdict = judge(at_);
    if (!verdict) return verdict.failure();
    swings_ = std::move(verdict->swings);
    stray_m_ = verdict->stray_m;
    result_.passes = verdict->passes;
    result_.motion = at_;
    return std::nullopt;
  }

  bool Passes() const { return feasible_ && result_.passes; }
  const RefinedMotion& result() const { return result_; }

  /// @return false where there is nothing else to try.
  bool PlanAnew() {
    // A closer grid of nodes is tried first, since it costs least. Then all swings become unknowns, kept clear of the
    // ground by planes; all of them, because a change that brings one swing back into reach takes others out of it. An
    // infeasible attempt is the start of the next one, with planes at its own swings, as long as the violation falls.
    if (!feasible_ && at_.choice.problem.swings.empty() && result_.changes == 0 && Halve()) return true;
    if (IsStuck()) return BeginElsewhere();
    if ((result_.halvings > 0 || rules_.most_halvings == 0) && (stray_m_ > 0.0 || !feasible_)) {
      PlanSwingsAlong(stray_m_, true);
      return true;
    }
    if (Halve()) return true;
    result_.refusal = "halving the node spacing again would not help";
    return false;
  }

 private:
  bool Halve() {
    RigidBodyOptions halved = options_;
    halved.spacing_s *= 0.5;
    halved.least_intervals *= 2;
    if (result_.halvings == rules_.most_halvings || !InRange(halved)) return false;
    ++result_.halvings;
    options_ = halved;
    Solve(false);
    return true;
  }

  /// Whether attempts in a row do not keep their laws, nor come nearer to it.
  bool IsStuck() {
    constexpr int kMostUnmet = 5;
    constexpr double kProgress = 0.7;
    unmet_ = feasible_ ? 0 : unmet_ + 1;
    const double before = std::exchange(missed_, at_.plan.summary.violations);
    return unmet_ > kMostUnmet || (unmet_ > 0 && at_.choice.problem.swings.empty()) ||
           (unmet_ > 1 && missed_ > kProgress * before);
  }

  /// First the same footholds and swings without an initial motion, then other patches from the best attempt, at first
  /// without swings.
  bool BeginElsewhere() {
    const bool first = !choices_.has_best(), has_swings = !at_.choice.problem.swings.empty();
    unmet_ = 0;
    if ((first || has_swings) && choices_.Offer(at_)) why_ = result_.refusal;
    if (first && has_swings) {
      PlanSwingsAlong(0.0, false);
      return true;
    }
    if (TakeOtherPatches()) return true;
    result_.refusal = why_;
    return false;
  }

  bool TakeOtherPatches() {
    if (result_.changes == rules_.most_changes) return false;
    std::optional<ChosenFootholds> changed = choices_.Next();
    if (!changed) return false;
    ++result_.changes;
    changed->problem.swings.clear();
    at_.choice = std::move(*changed);
    Solve(false);
    return true;
  }

  /// Swings that stray by little do so between the shares at which they are looked at: they are kept farther inside.
  void PlanSwingsAlong(double stray_m, bool from_numbers) {
    constexpr double kLittle = 5e-3, kLeastMargin = 2e-3;  // [m]
    const double more_m = stray_m < kLittle ? stray_m : 0.0;
    options_.reach_margin_m = std::max(kLeastMargin, options_.reach_margin_m + more_m);
    ++result_.swings_planned;
    TakeSwings(swings_, at_.choice.problem, at_.plan.numbers.x);
    Solve(from_numbers);
  }

  /// From the numbers of the attempt, or as if there were none. What is far from its laws at first takes its time.
  void Solve(bool from_numbers) {
    RigidBodyOptions options = options_;
    options.max_iterations *= 3;
    if (!InRange(options)) options = options_;
    options.infeasible = 1e3;
    RigidBodyPlan last;
    const Result<RigidBodyPlan> plan = from_numbers
                                           ? PlanRigidBodyFrom(at_.choice.problem, options, at_.plan.numbers, &last)
                                           : PlanRigidBody(at_.choice.problem, options, &last);
    feasible_ = plan.ok();
    result_.refusal = plan.ok() ? "" : plan.failure().message;
    at_.plan = std::move(last);
  }

  const Terrain& ground_;
  RigidBodyOptions options_;
  const RefineRules& rules_;
  RefinedMotion result_;
  PlanOverPatches at_;  // the attempt
  bool feasible_ = true;
  std::vector<RigidSwing> swings_;  // of the attempt
  double stray_m_ = 0.0;            // of its swings
  int unmet_ = 0;                   // infeasible attempts in a row
  double missed_ = 0.0;             // sum of the violations of the last one
  PatchChoices choices_;            // from the best attempt that was stuck,
  std::string why_;                 // and why that was refused
};

}  // namespace

Result<RefinedMotion> RefineMotion(const Terrain& ground, const PlanOverPatches& motion, RigidBodyOptions options,
                                   const RefineRules& rules, const MotionJudge& judge) {
  Refiner refiner(ground, motion, std::move(options), rules);
  for (int round = 0;; ++round) {
    if (const auto failure = refiner.Check(judge)) return *failure;
    if (refiner.Passes() || round == rules.most_rounds || !refiner.PlanAnew()) return refiner.result();
  }
}

}  // namespace gaitwright
