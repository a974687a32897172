// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/pipeline/carriage_search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace gaitwright {
namespace {

constexpr double kUnbounded = std::numeric_limits<double>::infinity();

/// More excess than the passes after the first can mend; such plans are finished only for those who want them.
constexpr double kHopeless = 0.05;

/// A change of the carriage that may have less excess.
struct Change {
  bool applies = false;
  bool in_reach = false;
  double lean_rad = 0.0;
  double inward = 1.0;  ///< factor of the preferred ZMP's share
};

/// In the order in which they are tried, each from what was best before.
std::vector<Change> ChangesFor(const CarriageProblem& problem) {
  constexpr double kLean = 0.1;    // [rad] moves the hips of NAO by 3 cm, a quarter of what a hip bends to behind
  constexpr double kInward = 2.0;  // more than twice the preferred share leaves no margin on the other side
  return {{problem.uneven, true, 0.0, 1.0},
          {problem.uneven && problem.on_one_sole, true, kLean, 1.0},
          {problem.on_one_sole && problem.zmp_inward > 0.0, false, 0.0, kInward}};
}

class CarriageSearch {
 public:
  CarriageSearch(const CarriageProblem& problem, const CarriageTrials& trials)
      : problem_(problem), trials_(trials), hopeless_(problem.finishes_all ? kUnbounded : kHopeless) {
    carriage_.com_height_m = problem.asked_m > 0.0 ? problem.asked_m : problem.standing_m;
    carriage_.zmp_inward = problem.zmp_inward;
  }

  Result<MotionPass> Run() {
    best_ = trials_.plan(carriage_, hopeless_);
    if (!best_ && best_.failure().code != FailureCode::kOutOfReach) return best_;
    for (const Change& change : ChangesFor(problem_)) {
      if (change.applies && Excess(best_) > 0.0) Try(change);
    }
    if (problem_.asked_m != 0.0 || Excess(best_) == 0.0 || !Lower()) return std::move(best_);
    // What did not help the higher body may be all that the lower one lacks.
    for (const Change& change : ChangesFor(problem_)) {
      const bool is_posture = change.lean_rad != 0.0 || change.inward != 1.0;
      if (change.applies && is_posture && !IsMade(change) && Excess(best_) > 0.0) Try(change);
    }
    return std::move(best_);
  }

 private:
  static double Excess(const Result<MotionPass>& pass) { return pass ? pass->excess : kUnbounded; }

  bool IsMade(const Change& change) const {
    return change.lean_rad != 0.0 ? carriage_.lean_rad != 0.0 : carriage_.zmp_inward != problem_.zmp_inward;
  }

  void Try(const Change& change) {
    Carriage changed = carriage_;
    changed.in_reach |= change.in_reach;
    changed.lean_rad += change.lean_rad;
    changed.zmp_inward *= change.inward;
    // The ZMP does not bring a foot within reach; that it runs inward is for lower bodies to use.
    const bool is_known = change.inward != 1.0 && !best_;
    if (is_known || Take(trials_.plan(changed, hopeless_))) carriage_ = changed;
  }

  /// Takes what has less excess.
  bool Take(Result<MotionPass> other) {
    if (Excess(other) >= Excess(best_)) return false;
    best_ = std::move(other);
    return true;
  }

  /// @return whether a lower body has less excess; it is kept.
  bool Lower() {
    constexpr double kStep = 0.02, kLowest = 0.8;  // of the standing height
    constexpr int kPatience = 2;                   // heights without gain
    const auto at = [&](double share) {
      Carriage lower = carriage_;
      lower.com_height_m = share * problem_.standing_m;
      return lower;
    };
    // What is out of reach at the lowest is so at all heights.
    if (!best_ && !trials_.reaches(at(kLowest))) return false;
    const double before = carriage_.com_height_m;
    double gain = kUnbounded;
    int without_gain = 0;
    for (double share = 1.0 - kStep; share >= kLowest && Excess(best_) > 0.0 && without_gain < kPatience;
         share -= kStep) {
      // Lowering helps less and less: the rest is not tried where it cannot be enough.
      const double least = Excess(best_), steps_left = std::round((share - kLowest) / kStep) + 1.0;
      if (least - gain * steps_left > (least > hopeless_ ? hopeless_ : 0.0)) break;
      Result<MotionPass> lower = trials_.plan(at(share), hopeless_);
      const double excess = Excess(lower);
      without_gain = excess < least || !lower ? 0 : without_gain + 1;
      gain = !lower ? gain : std::max(0.0, least - excess);
      if (Take(std::move(lower))) carriage_ = at(share);
    }
    return carriage_.com_height_m != before;
  }

  const CarriageProblem& problem_;
  const CarriageTrials& trials_;
  const double hopeless_;
  Carriage carriage_;  // the best so far
  Result<MotionPass> best_ = MotionPass{};
};

}  // namespace

Result<MotionPass> FindCarriage(const CarriageProblem& problem, const CarriageTrials& trials) {
  return CarriageSearch(problem, trials).Run();
}

}  // namespace gaitwright
