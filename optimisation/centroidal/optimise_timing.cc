// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/centroidal/optimise_timing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "optimisation/centroidal/cost_by_durations.h"
#include "optimisation/centroidal/phase_durations.h"
#include "optimisation/centroidal/rigid_body_unknowns.h"

namespace gaitwright {
namespace {

VectorX DurationsOf(const std::vector<double>& switches) {
  VectorX durations(static_cast<Eigen::Index>(switches.size()) - 1);
  for (Eigen::Index i = 0; i < durations.size(); ++i)
    durations[i] = switches[static_cast<std::size_t>(i) + 1] - switches[static_cast<std::size_t>(i)];
  return durations;
}

/// Shortest durations of the phases: by the options, and as parts of the swings between stances of a foot.
VectorX ShortestOf(const RigidBodyProblem& problem, const std::vector<double>& switches, const TimingOptions& options) {
  const VectorX durations = DurationsOf(switches);
  VectorX shortest = VectorX::Constant(durations.size(), options.shortest_s);
  for (std::size_t from = 0; from < problem.stances.size(); ++from) {
    for (std::size_t to = from + 1; to < problem.stances.size(); ++to) {
      if (problem.stances[to].foot != problem.stances[from].foot) continue;
      const double start = problem.stances[from].end_s, end = problem.stances[to].start_s;
      const double share = std::min(1.0, options.shortest_swing_s / (end - start));
      for (Eigen::Index i = 0; i < durations.size(); ++i) {
        const double middle = switches[static_cast<std::size_t>(i)] + 0.5 * durations[i];
        if (middle > start && middle < end) shortest[i] = std::max(shortest[i], share * durations[i]);
      }
      break;
    }
  }
  return shortest;
}

Failure NoTiming(const VectorX& durations, const char* which, const char* of_total, double total_s) {
  return {FailureKind::kInfeasible,
          FailureCode::kNoTiming,
          "OptimiseTiming",
          fmt::format("the {} durations of the {} phases sum to {:g} s; the {} accepted total is {:g} s", which,
                      durations.size(), durations.sum(), of_total, total_s),
          {"change shortest_s, shortest_swing_s, longest_s, least_total or most_total"}};
}

class TimingSearch {
 public:
  TimingSearch(const RigidBodyProblem& problem, const RigidBodyOptions& planning, const TimingOptions& options,
               const PhaseTies* ties)
      : planning_(planning), options_(options), ties_(ties) {
    best_.problem = problem;
    switches_ = SwitchTimes(problem);
    least_end_s_ = (ties == nullptr ? options.least_total : 1.0) * problem.duration_s;
    most_end_s_ = (ties == nullptr ? options.most_total : 1.0) * problem.duration_s;
    if (ties != nullptr) {
      best_.parts_s = ties->parts_s;
      const double sum = ties->parts_s.sum();
      bounds_ = {ties->shortest_s, VectorX::Constant(ties->parts_s.size(), options.longest_s), sum, sum};
      return;
    }
    const auto phases = static_cast<Eigen::Index>(switches_.size()) - 1;
    bounds_ = {ShortestOf(problem, switches_, options), VectorX::Constant(phases, options.longest_s), least_end_s_,
               most_end_s_};
  }

  Result<TimedPlan> Run(const RigidBodyPlan* given) {
    if (const std::optional<Failure> refusal = Refusal()) return *refusal;
    const bool moved = BringWithinBounds();
    Result<RigidBodyPlan> first =
        given != nullptr && !moved ? Result<RigidBodyPlan>(*given) : PlanRigidBody(best_.problem, planning_);
    if (!first) first = Mended(first.failure());
    if (!first) return first.failure();
    best_.plan = *first;
    best_.first_cost = first->summary.cost;
    Search();
    PlaceNodesAgain();
    return best_;
  }

 private:
  std::optional<Failure> Refusal() const {
    if (bounds_.lower.maxCoeff() > options_.longest_s) {
      return Failure{FailureKind::kBadInput,
                     FailureCode::kNoDuration,
                     "OptimiseTiming",
                     fmt::format("the shortest phase duration, {:g} s, is above the longest, {:g} s",
                                 bounds_.lower.maxCoeff(), options_.longest_s),
                     {"lower shortest_s or shortest_swing_s, or raise longest_s"}};
    }
    constexpr double kDigits = 1e-9;
    if (bounds_.lower.sum() > (1.0 + kDigits) * bounds_.most_total_s)
      return NoTiming(bounds_.lower, "shortest", "longest", bounds_.most_total_s);
    if (bounds_.upper.sum() < (1.0 - kDigits) * bounds_.least_total_s)
      return NoTiming(bounds_.upper, "longest", "shortest", bounds_.least_total_s);
    if (IsRetimable(best_.problem)) return std::nullopt;
    return Failure{FailureKind::kBadInput,
                   FailureCode::kTiedToTime,
                   "OptimiseTiming",
                   "leg angular momentum, motor limits and clearances are given for fixed times, so the timing cannot "
                   "be optimised",
                   {"leave them out, and compute them again for the optimised times"}};
  }

  /// The variables: durations of the phases, or of the parts from which they follow.
  VectorX Variables() const { return ties_ == nullptr ? DurationsOf(switches_) : best_.parts_s; }

  /// The switch times for these durations; the total is exactly within its bounds.
  std::vector<double> SwitchesOf(const VectorX& variables) const {
    const VectorX durations =
        ties_ == nullptr ? variables : VectorX(ties_->phases_by_parts * variables + ties_->rest_s);
    std::vector<double> switches = {0.0};
    for (const double d : durations) switches.push_back(switches.back() + d);
    switches.back() = std::clamp(switches.back(), least_end_s_, most_end_s_);
    return switches;
  }

  /// Gradient of the optimal cost with respect to the variables.
  VectorX SlopeOf(const RigidBodyProblem& problem, const RigidBodyNumbers& numbers) const {
    const VectorX slope = CostByDurations(problem, planning_, numbers);
    return ties_ == nullptr ? slope : VectorX(ties_->phases_by_parts.transpose() * slope);
  }

  void Take(const VectorX& variables, std::vector<double> switches) {
    if (ties_ != nullptr) best_.parts_s = variables;
    switches_ = std::move(switches);
  }

  /// @return whether durations were out of bounds.
  bool BringWithinBounds() {
    const VectorX given = Variables(), nearest = NearestDurations(given, bounds_);
    if (nearest == given) return false;
    const std::vector<double> to = SwitchesOf(nearest);
    best_.problem = Retimed(best_.problem, TimeMap(switches_, to));
    Take(nearest, to);
    return true;
  }

  /// Penalty of a motion for violated constraints.
  double Paid(const RigidBodySummary& summary) const {
    return summary.cost + 2.0 * planning_.max_penalty * summary.violations;
  }

  /// Searches for times with a feasible motion after a failure.
  Result<RigidBodyPlan> Mended(Failure failure) {
    // The derivatives are accurate only if the solve has converged.
    RigidBodyOptions patient = planning_;
    patient.early_check = patient.max_iterations = std::max(kPatience, planning_.max_iterations);
    RigidBodyPlan at;
    Result<RigidBodyPlan> plan = PlanRigidBody(best_.problem, patient, &at);
    change_ = options_.first_change;
    best_.mended = true;
    while (!plan && best_.solves < options_.max_solves && change_ > kLeastChange) {
      ++best_.solves;
      if (at.summary.violation <= planning_.tolerance) {
        // The remaining violations are between nodes, which were kept.
        plan = PlanRigidBody(best_.problem, planning_);
        break;
      }
      const VectorX given = Variables();
      const VectorX slope = SlopeOf(best_.problem, at.numbers);
      const MatrixX straight = MatrixX::Zero(slope.size(), slope.size());
      const VectorX wanted = BestDurations(given, slope, straight, change_ * given, bounds_);
      const std::vector<double> to = SwitchesOf(wanted);
      const TimeMap map(switches_, to);
      RigidBodyProblem problem = Retimed(best_.problem, map);
      RigidBodyPlan other;
      plan = PlanRigidBodyFrom(problem, patient, Retimed(at.numbers, map), &other);
      if (!plan && Paid(other.summary) >= Paid(at.summary)) {
        change_ *= kLess;
        continue;
      }
      best_.problem = std::move(problem);
      at = std::move(other);
      Take(wanted, to);
    }
    if (plan) return plan;
    failure.message += fmt::format("; with other contact times, a violation of {:.3g} remains", at.summary.violations);
    return failure;
  }

  void Search() {
    slope_ = SlopeOf(best_.problem, best_.plan.numbers);
    change_ = options_.first_change;
    const int most = best_.solves + options_.max_solves;
    while (best_.solves < most && change_ > kLeastChange) {
      if (!Step()) return;
    }
  }

  /// @return false if the cost can fall no further.
  bool Step() {
    const VectorX durations = Variables();
    if (curvature_.size() == 0) curvature_ = MatrixX::Zero(durations.size(), durations.size());
    const VectorX wanted = BestDurations(durations, slope_, curvature_, change_ * durations, bounds_);
    const VectorX step = wanted - durations;
    const double promised = -slope_.dot(step) - 0.5 * step.dot(curvature_ * step);
    const double little = options_.least_gain * best_.plan.summary.cost;
    if (promised < little) return false;
    const std::vector<double> to = SwitchesOf(wanted);
    const TimeMap map(switches_, to);
    RigidBodyProblem problem = Retimed(best_.problem, map);
    ++best_.solves;
    const Result<RigidBodyPlan> plan = PlanRigidBodyFrom(problem, planning_, Retimed(best_.plan.numbers, map));
    if (!plan) {
      change_ *= kLess;
      return true;
    }
    const double gained = best_.plan.summary.cost - plan->summary.cost;
    const VectorX slope = SlopeOf(problem, plan->numbers);
    Learn(durations, step, slope - slope_);
    if (gained < kPoor * promised) change_ *= kLess;
    if (gained > kGood * promised) change_ = std::min(options_.most_change, kMore * change_);
    if (!(gained > 0.0)) return true;
    best_.problem = std::move(problem);
    best_.plan = *plan;
    ++best_.steps;
    Take(wanted, to);
    slope_ = slope;
    return gained >= little;
  }

  /// Updates the curvature from a step; it stays positive definite. The first step gives its scale, assumed to be equal
  /// for relative changes of all durations.
  void Learn(const VectorX& durations, const VectorX& step, VectorX change) {
    constexpr double kLeastBend = 0.2;
    if (curvature_.isZero()) {
      const VectorX weight = durations.cwiseAbs2().cwiseInverse();
      curvature_ = (std::abs(step.dot(change)) / step.dot(weight.cwiseProduct(step)) * weight).asDiagonal();
    }
    const VectorX moved = curvature_ * step;
    const double bend = step.dot(moved), seen = step.dot(change);
    if (!(bend > 0.0)) return;
    if (seen < kLeastBend * bend) {
      const double share = (1.0 - kLeastBend) * bend / (bend - seen);
      change = share * change + (1.0 - share) * moved;
    }
    curvature_ += change * change.transpose() / step.dot(change) - moved * moved.transpose() / bend;
  }

  void PlaceNodesAgain() {
    const RigidBodyUnknowns asked(best_.problem, planning_.spacing_s, planning_.least_intervals, planning_.grid_s);
    if (asked.nodes_s().size() <= best_.plan.numbers.nodes_s.size()) return;
    ++best_.solves;
    const Result<RigidBodyPlan> plan = PlanRigidBody(best_.problem, planning_);
    if (plan && plan->summary.cost <= best_.plan.summary.cost) best_.plan = *plan;
  }

  static constexpr int kPatience = 200;
  static constexpr double kLeastChange = 0.01;
  static constexpr double kPoor = 0.25, kGood = 0.7, kLess = 0.4, kMore = 1.7;
  const RigidBodyOptions planning_;
  const TimingOptions options_;
  const PhaseTies* ties_;
  TimedPlan best_;
  std::vector<double> switches_;
  double least_end_s_ = 0.0, most_end_s_ = 0.0;
  DurationBounds bounds_;
  VectorX slope_;
  MatrixX curvature_;
  double change_ = 0.0;  // largest relative change of a duration in a step
};

}  // namespace

OptionFields TimingOptions::PhaseFields() {
  return WithBasics(
      {"shortest_s", "longest_s", "max_solves"},
      {
          {"shortest_s", &shortest_s, "s", 1e-3, 100.0, "Shortest duration of a phase."},
          {"longest_s", &longest_s, "s", 1e-3, 1e4, "Longest duration of a phase."},
          {"shortest_swing_s", &shortest_swing_s, "s", 0.0, 100.0,
           "Shortest duration of a foot's swing; a swing that is shorter at first must not become even shorter."},
          {"first_change", &first_change, "1", 0.01, 0.9,
           "Largest relative change of a phase's duration in the first step of the optimiser."},
          {"most_change", &most_change, "1", 0.01, 0.9,
           "Largest relative change of a phase's duration in any step of the optimiser."},
          {"least_gain", &least_gain, "1", 1e-6, 1.0,
           "Relative decrease of the cost below which the optimisation ends."},
          {"max_solves", &max_solves, "1", 0, 1000,
           "Maximum number of motions planned to lower the cost; the search for a first feasible motion has the same "
           "limit again."},
      });
}

OptionFields TimingOptions::Fields() {
  return Joined(
      {PhaseFields(),
       {{"least_total", &least_total, "1", 0.01, 1.0, "Shortest total time, as a share of the given total time."},
        {"most_total", &most_total, "1", 1.0, 100.0, "Longest total time, as a multiple of the given total time."}}});
}

Result<TimedPlan> OptimiseTiming(const RigidBodyProblem& problem, const RigidBodyOptions& planning,
                                 const TimingOptions& options, const RigidBodyPlan* first, const PhaseTies* ties) {
  CheckRigidBodyProblem(problem);
  TimingOptions checked = options;
  CheckOptions(checked.Fields());
  return TimingSearch(problem, planning, options, ties).Run(first);
}

}  // namespace gaitwright
