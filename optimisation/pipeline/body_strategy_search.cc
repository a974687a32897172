// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/pipeline/body_strategy_search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "optimisation/pipeline/limit_violation.h"

namespace gaitwright {
namespace {

constexpr double kUnbounded = std::numeric_limits<double>::infinity();

/// Limit violation that later passes cannot correct; motions beyond it are completed only on request.
constexpr double kInfeasible = 0.05;

/// A change of the body posture that may reduce the limit violation.
struct Change {
  bool applies = false;
  bool in_reach = false;
  double lean_rad = 0.0;
  double inward = 1.0;  ///< factor of zmp_inward
};

/// In the order of the trials. Each change starts from the best posture so far.
std::vector<Change> ChangesFor(const BodyStrategyProblem& problem) {
  constexpr double kLean = 0.1;  // [rad] moves the hips of a humanoid by 3 cm, a quarter of the rearward bend of a hip
  constexpr double kInward = 2.0;  // more than twice the preferred share leaves no margin on the other side
  return {{problem.uneven, true, 0.0, 1.0},
          {problem.uneven && problem.on_one_sole, true, kLean, 1.0},
          {problem.on_one_sole && problem.zmp_inward > 0.0, false, 0.0, kInward}};
}

class BodyStrategySearch {
 public:
  BodyStrategySearch(const BodyStrategyProblem& problem, const BodyStrategyTrials& trials)
      : problem_(problem), trials_(trials), infeasible_(problem.finishes_all ? kUnbounded : kInfeasible) {
    strategy_.com_height_m = problem.asked_m > 0.0 ? problem.asked_m : problem.standing_m;
    strategy_.zmp_inward = problem.zmp_inward;
  }

  Result<MotionPass> Run() {
    best_ = trials_.plan(strategy_, infeasible_);
    if (!best_ && best_.failure().code != FailureCode::kOutOfReach) return best_;
    if (best_ && best_->violation >= kSlightViolation && trials_.mends(*best_)) return std::move(best_);
    for (const Change& change : ChangesFor(problem_)) {
      if (change.applies && ViolationSum(best_) > 0.0) Try(change);
    }
    if (problem_.asked_m != 0.0 || ViolationSum(best_) == 0.0 || !Lower()) return std::move(best_);
    // A change that did not help the higher body may help the lower one.
    for (const Change& change : ChangesFor(problem_)) {
      const bool is_posture = change.lean_rad != 0.0 || change.inward != 1.0;
      if (change.applies && is_posture && !IsMade(change) && ViolationSum(best_) > 0.0) Try(change);
    }
    return std::move(best_);
  }

 private:
  static double ViolationSum(const Result<MotionPass>& pass) { return pass ? pass->violation : kUnbounded; }

  bool IsMade(const Change& change) const {
    return change.lean_rad != 0.0 ? strategy_.lean_rad != 0.0 : strategy_.zmp_inward != problem_.zmp_inward;
  }

  void Try(const Change& change) {
    BodyStrategy changed = strategy_;
    changed.in_reach |= change.in_reach;
    changed.lean_rad += change.lean_rad;
    changed.zmp_inward *= change.inward;
    // The inward ZMP does not bring feet into reach; it is only useful together with a lowered body.
    const bool is_known = change.inward != 1.0 && !best_;
    if (is_known || Take(trials_.plan(changed, infeasible_))) strategy_ = changed;
  }

  /// Keeps a motion if its limit violation is smaller.
  bool Take(Result<MotionPass> other) {
    if (ViolationSum(other) >= ViolationSum(best_)) return false;
    best_ = std::move(other);
    return true;
  }

  /// @return whether a lower body has a smaller violation; it is kept.
  bool Lower() {
    constexpr double kStep = 0.02, kLowest = 0.8;  // share of the standing height
    constexpr int kPatience = 2;                   // number of heights without improvement
    const auto at = [&](double share) {
      BodyStrategy lower = strategy_;
      lower.com_height_m = share * problem_.standing_m;
      return lower;
    };
    // A foothold out of reach at the lowest height is out of reach at all heights.
    if (!best_ && !trials_.reaches(at(kLowest))) return false;
    const double before = strategy_.com_height_m;
    double gain = kUnbounded;
    int without_gain = 0;
    for (double share = 1.0 - kStep; share >= kLowest && ViolationSum(best_) > 0.0 && without_gain < kPatience;
         share -= kStep) {
      // Each further lowering helps less, so the search ends if the remaining heights cannot suffice.
      const double least = ViolationSum(best_), steps_left = std::round((share - kLowest) / kStep) + 1.0;
      if (least - gain * steps_left > (least > infeasible_ ? infeasible_ : 0.0)) break;
      Result<MotionPass> lower = trials_.plan(at(share), infeasible_);
      const double violation = ViolationSum(lower);
      without_gain = violation < least || !lower ? 0 : without_gain + 1;
      gain = !lower ? gain : std::max(0.0, least - violation);
      if (Take(std::move(lower))) strategy_ = at(share);
    }
    return strategy_.com_height_m != before;
  }

  const BodyStrategyProblem& problem_;
  const BodyStrategyTrials& trials_;
  const double infeasible_;
  BodyStrategy strategy_;  // the best so far
  Result<MotionPass> best_ = MotionPass{};
};

}  // namespace

Result<MotionPass> FindBodyStrategy(const BodyStrategyProblem& problem, const BodyStrategyTrials& trials) {
  return BodyStrategySearch(problem, trials).Run();
}

}  // namespace gaitwright
