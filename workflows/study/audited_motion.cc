// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/study/audited_motion.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include "planning/audit/audit.h"
#include "workflows/study/free_swings.h"
#include "workflows/study/rigid_body_plan.h"
#include "workflows/study/rigid_body_robot.h"

namespace gaitwright {
namespace {

/// Largest excess of a prismatic joint over its limit [m].
double StrayOf(const AuditReport& report) {
  double stray_m = 0.0;
  for (const Violation& v : report.violations) {
    if (v.law == Law::kJointPosition) stray_m = std::max(stray_m, std::abs(v.value - v.limit));
  }
  return stray_m;
}

/// Whether all options are in their ranges; refinement may leave the ranges.
bool InRange(RigidBodyOptions options) {
  try {
    CheckOptions(options.Fields());
  } catch (const InvalidArgument&) {
    return false;
  }
  return true;
}

/// Repeats audit and planning in rounds.
class Refiner {
 public:
  Refiner(const Terrain& ground, const PlanOverPatches& plan, RigidBodyOptions options, AuditedMotion& motion)
      : ground_(ground), options_(std::move(options)), motion_(motion), at_(plan) {}

  /// Audits the attempt if it satisfies its constraints. @return the failure if it cannot be audited.
  std::optional<Failure> Judge() {
    const RigidBodyProblem& problem = at_.choice.problem;
    if (!keeps_laws_) {
      swings_ = FreeSwingsOf(ground_, problem, at_.plan.motion);
      return std::nullopt;
    }
    const Result<RobotModel> robot = RigidBodyRobot(problem, "rigid-body");
    if (!robot) return robot.failure();
    const Result<MotionPlan> plan = RigidBodyMotionPlan(*robot, ground_, problem, at_.plan.motion);
    if (!plan) return plan.failure();
    const Result<AuditReport> report = Audit(*robot, *plan, {});
    if (!report) return report.failure();
    swings_ = FreeSwingsOf(ground_, problem, *plan, ProblemFeetOf(*robot, problem));
    motion_.report = *report;
    motion_.choice = at_.choice;
    motion_.plan = at_.plan;
    return std::nullopt;
  }

  bool Passes() const { return keeps_laws_ && motion_.report.pass(); }

  /// Plans again. @return false if nothing is left to try.
  bool PlanAnew() {
    // First halve the node spacing, since that costs least. Then plan swings together with the body, separated from the
    // ground by planes. If an attempt violates constraints, continue from it while the violation decreases, with planes
    // at its swings. All swings are planned together, because a correction of one can move others out of their
    // workspaces.
    const double stray_m = keeps_laws_ ? StrayOf(motion_.report) : 0.0;
    if (!keeps_laws_ && at_.choice.problem.swings.empty() && motion_.changes == 0 && Halve()) return true;
    if (IsStuck()) return BeginElsewhere();
    if (motion_.halvings > 0 && (stray_m > 0.0 || !keeps_laws_)) {
      PlanSwingsAlong(stray_m, true);
      return true;
    }
    if (Halve()) return true;
    motion_.refusal = "halving the node spacing again would not help";
    return false;
  }

 private:
  bool Halve() {
    constexpr int kMostHalvings = 2;
    RigidBodyOptions halved = options_;
    halved.spacing_s *= 0.5;
    halved.least_intervals *= 2;
    if (motion_.halvings == kMostHalvings || !InRange(halved)) return false;
    ++motion_.halvings;
    options_ = halved;
    Solve(false);
    return true;
  }

  /// Whether several attempts in sequence violate constraints and the violation does not decrease.
  bool IsStuck() {
    constexpr int kMostUnmet = 5;
    constexpr double kProgress = 0.7;
    unmet_ = keeps_laws_ ? 0 : unmet_ + 1;
    const double before = std::exchange(missed_, at_.plan.summary.violations);
    return unmet_ > kMostUnmet || (unmet_ > 0 && at_.choice.problem.swings.empty()) ||
           (unmet_ > 1 && missed_ > kProgress * before);
  }

  /// Tries the same footholds and swings from a new initial guess, then other patches, starting at the smallest
  /// constraint violation, at first without swings.
  bool BeginElsewhere() {
    constexpr double kBetter = 0.95, kNear = 0.6;  // [1], [m]
    const bool first = !stuck_, has_swings = !at_.choice.problem.swings.empty();
    unmet_ = 0;
    if (first || (has_swings && missed_ < kBetter * stuck_->plan.summary.violations)) {
      stuck_ = at_;
      why_ = motion_.refusal;
      tried_.insert(at_.choice.patches);
      changes_ = PatchChanges(ground_, at_, kEdgeMargin, kNear);
      next_ = 0;
    }
    if (first && has_swings) {
      PlanSwingsAlong(0.0, false);
      return true;
    }
    if (TakeOtherPatches()) return true;
    motion_.refusal = why_;
    return false;
  }

  bool TakeOtherPatches() {
    constexpr int kMostChanges = 12;
    while (next_ < changes_.size() && motion_.changes < kMostChanges) {
      ChosenFootholds changed = Changed(ground_, *stuck_, changes_[next_++], kEdgeMargin);
      if (!tried_.insert(changed.patches).second) continue;
      ++motion_.changes;
      changed.problem.swings.clear();
      at_.choice = std::move(changed);
      Solve(false);
      return true;
    }
    return false;
  }

  /// Plans swings together with the body. A small excess occurs between the points at which swings are checked, so
  /// their margin is increased by it.
  void PlanSwingsAlong(double stray_m, bool from_numbers) {
    constexpr double kLittle = 5e-3, kLeastMargin = 2e-3;  // [m]
    const double more_m = stray_m < kLittle ? stray_m : 0.0;
    options_.reach_margin_m = std::max(kLeastMargin, options_.reach_margin_m + more_m);
    ++motion_.swings_planned;
    TakeSwings(swings_, at_.choice.problem, at_.plan.numbers.x);
    Solve(from_numbers);
  }

  /// Solves from the numbers of the attempt, or from a new initial guess, which needs more iterations.
  void Solve(bool from_numbers) {
    RigidBodyOptions options = options_;
    options.max_iterations *= 3;
    if (!InRange(options)) options = options_;
    options.infeasible = 1e3;
    RigidBodyPlan last;
    const Result<RigidBodyPlan> plan = from_numbers
                                           ? PlanRigidBodyFrom(at_.choice.problem, options, at_.plan.numbers, &last)
                                           : PlanRigidBody(at_.choice.problem, options, &last);
    keeps_laws_ = plan.ok();
    motion_.refusal = plan.ok() ? "" : plan.failure().message;
    at_.plan = std::move(last);
  }

  static constexpr double kEdgeMargin = 0.01;  // [m] distance of footholds on other patches from edges

  const Terrain& ground_;
  RigidBodyOptions options_;
  AuditedMotion& motion_;
  PlanOverPatches at_;  // present attempt
  bool keeps_laws_ = true;
  std::vector<RigidSwing> swings_;        // swings of the attempt
  int unmet_ = 0;                         // number of successive attempts that violate constraints
  double missed_ = 0.0;                   // total constraint violation of the last one
  std::optional<PlanOverPatches> stuck_;  // best attempt without further progress
  std::string why_;                       // reason for its refusal
  std::vector<PatchChange> changes_;      // changes of patches left to try from it
  std::size_t next_ = 0;                  // index of the next change
  std::set<std::vector<int>> tried_;      // patches, by stance
};

}  // namespace

Result<AuditedMotion> RefineByAudit(const Terrain& ground, const PlanOverPatches& plan, RigidBodyOptions options,
                                    int most_rounds) {
  AuditedMotion motion{plan.choice, plan.plan};
  Refiner refiner(ground, plan, std::move(options), motion);
  for (int round = 0;; ++round) {
    if (const auto failure = refiner.Judge()) return *failure;
    if (round == 0) motion.first = motion.report;
    if (refiner.Passes() || round == most_rounds) break;
    if (!refiner.PlanAnew()) break;
  }
  return motion;
}

}  // namespace gaitwright
