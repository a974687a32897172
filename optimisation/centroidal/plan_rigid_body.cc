// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/centroidal/plan_rigid_body.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "optimisation/centroidal/hold_goal.h"
#include "optimisation/centroidal/rigid_body_rows.h"
#include "optimisation/centroidal/rigid_body_terms.h"
#include "optimisation/centroidal/rigid_body_unknowns.h"
#include "optimisation/numerics/elastic_interior.h"

namespace gaitwright {
namespace {

/// Text for the failure if no forces on the footholds at the goal can hold the body there; otherwise empty.
std::string TooSteepAtGoal(const RigidBodyProblem& problem) {
  std::vector<Vector3> normals_W;
  double friction = 0.0;
  for (const RigidStance& stance : problem.stances) {
    if (stance.end_s < problem.duration_s) continue;
    normals_W.push_back(stance.X_WF.linear().col(2));
    friction = std::max(friction, stance.friction);
  }
  const double needed = LeastHoldingFriction(normals_W);
  if (needed <= friction) return "";
  return fmt::format(
      "; at the goal, all feet are on ground that needs a friction of {:.2f} to stand on, but {:.2f} may be used",
      needed, friction);
}

/// Text of the three largest violations and their total.
std::string UnmetOf(const ConstrainedSolution& at) {
  std::string unmet;
  for (std::size_t i = 0; i < std::min<std::size_t>(3, at.unmet.size()); ++i)
    unmet += fmt::format("{}{}{} by {:.3g}", i == 0 ? "" : ", ", at.unmet[i].first, i == 0 ? " stays violated" : "",
                         at.unmet[i].second);
  return fmt::format("{}{} after {} iterations; {:.3g} in all{}", unmet, at.unmet.size() > 3 ? " and more" : "",
                     at.iterations, at.violations, at.least ? ", which small changes of the motion do not reduce" : "");
}

/// Suggestion for a violated constraint.
std::string ReliefOf(RigidBodyRowKind worst) {
  switch (worst) {
    case RigidBodyRowKind::kReach:
      return "reduce the travel in a stance: lower speed, shorter cycle, or footholds closer together";
    case RigidBodyRowKind::kFriction:
    case RigidBodyRowKind::kMotors:
      return "reduce the forces: larger duty factor, lower speed or more time; or raise the friction";
    case RigidBodyRowKind::kRise:
    case RigidBodyRowKind::kFreeFlight:
      return "shorten the flights: shorter cycle or larger duty factor";
    case RigidBodyRowKind::kClearance:
      return "move ground or obstacles farther from the body, or raise the body";
    case RigidBodyRowKind::kRegion:
      return "put footholds on larger or other patches";
    case RigidBodyRowKind::kTurning:
      return "let feet stand longer, so that they can turn the body: larger duty factor";
    case RigidBodyRowKind::kOther:
      break;
  }
  return "give more time";
}

Failure Unmet(const RigidBodyProblem& problem, RigidBodyRowKind worst, const std::string& unmet) {
  return {FailureKind::kInfeasible,
          FailureCode::kUnmetLaw,
          "PlanRigidBody",
          "no motion was found that satisfies all constraints: " + unmet + TooSteepAtGoal(problem),
          {ReliefOf(worst), "choose a closer goal, or other footholds"}};
}

Failure FaultsBetween(const RigidBodySummary& summary) {
  return {FailureKind::kInfeasible,
          FailureCode::kFaultsBetween,
          "PlanRigidBody",
          fmt::format("between nodes, {} is violated by {:.3g} after {} refinements", summary.faults.Worst(),
                      summary.faults.Largest(), summary.refinements),
          {"raise max_refinements or reach_margin_m"}};
}

/// The result of the early infeasibility check, if constraints are clearly violated; otherwise nothing.
std::optional<ConstrainedSolution> Infeasible(const RigidBodyProblem& problem, const RigidBodyOptions& options) {
  constexpr double kNearly = 1e-2;  // violations below it are not clearly infeasible
  const RigidBodyUnknowns unknowns(problem, options.spacing_s, options.least_intervals, options.grid_s);
  ConstrainedProblem rows = RigidBodyRows(problem, unknowns, options, {});
  rows.start = GuessRigidBody(problem, unknowns);
  ElasticOptions solving;
  solving.tolerance = solving.cost_tolerance = kNearly;
  solving.penalty = options.penalty;
  solving.max_penalty = options.max_penalty;
  solving.early_check = options.early_check;
  solving.infeasible = options.infeasible;
  solving.max_iterations = options.early_check;
  ConstrainedSolution at;
  if (SolveElastic(rows, solving, &at).ok() || at.violations <= options.infeasible) return std::nullopt;
  return at;
}

/// Plans over nodes. Halves the node spacing or adds reach checks where needed.
class RigidBodyPlanner {
 public:
  RigidBodyPlanner(const RigidBodyProblem& problem, const RigidBodyOptions& options)
      : problem_(problem), options_(options) {}

  Result<RigidBodyPlan> Run() {
    SetNodes();
    return Refined();
  }

  /// Starts from given variables, with fixed nodes.
  Result<RigidBodyPlan> RunFrom(const RigidBodyNumbers& from) {
    unknowns_.emplace(problem_, from.nodes_s);
    missed_ = from.missed;
    start_ = from.x;
    first_gap_ = kNextGap;
    nodes_are_fixed_ = true;
    if (from.x.size() != unknowns_->size())
      throw InvalidArgument(
          fmt::format("PlanRigidBodyFrom: {} numbers for {} unknowns", from.x.size(), unknowns_->size()));
    return Refined();
  }

  const RigidBodyPlan& plan() const { return plan_; }

 private:
  /// Solves; repeats with a smaller node spacing or more reach checks while needed.
  Result<RigidBodyPlan> Refined() {
    while (true) {
      SolveOnce();
      if (not_carried_) return *not_carried_;
      RigidBodySummary& summary = plan_.summary;
      if (summary.violation > options_.tolerance) return Unmet(problem_, worst_, summary.unmet);
      if (summary.faults.Largest() <= options_.fault_tolerance) return plan_;
      if (summary.refinements == options_.max_refinements) return FaultsBetween(summary);
      ++summary.refinements;
      if (!LookCloser()) {
        if (nodes_are_fixed_) return FaultsBetween(summary);
        options_.spacing_s *= 0.5;
        options_.least_intervals *= 2;
        SetNodes();
      }
    }
  }

  void SetNodes() {
    unknowns_.emplace(problem_, options_.spacing_s, options_.least_intervals, options_.grid_s);
    missed_.clear();
    start_ = GuessRigidBody(problem_, *unknowns_);
    first_gap_ = kFirstGap;
  }

  /// Adds reach checks if only reach is violated. @return false if other constraints are violated.
  bool LookCloser() {
    RigidBodyFaults others = plan_.summary.faults;
    others.reach_m = 0.0;
    if (others.Largest() > options_.fault_tolerance) return false;
    const std::vector<MissedReach> more = MissedReaches(problem_, plan_.motion, 0.5 * options_.fault_tolerance);
    missed_.insert(missed_.end(), more.begin(), more.end());
    first_gap_ = kNextGap;
    return true;
  }

  bool SolveByInteriorPoint(const ConstrainedProblem& rows, ConstrainedSolution& at) const {
    ElasticOptions solving;
    solving.tolerance = options_.tolerance;
    solving.cost_tolerance = options_.cost_tolerance;
    solving.penalty = options_.penalty;
    solving.max_penalty = options_.max_penalty;
    solving.first_gap = first_gap_;
    solving.early_check = options_.early_check;
    solving.infeasible = options_.infeasible;
    solving.max_iterations = options_.max_iterations;
    return SolveElastic(rows, solving, &at).ok();
  }

  bool SolveByCeres(const ConstrainedProblem& rows, ConstrainedSolution& at) {
    ConstrainedOptions solving;
    solving.tolerance = options_.tolerance;
    solving.cost_tolerance = options_.cost_tolerance;
    solving.stiffness = 300.0;
    solving.trust_radius = 1e7;
    solving.inner_tolerance = 1e-4;
    solving.patience = 5;
    solving.max_outer = 25;
    solving.max_inner = 40;
    solving.max_steps = 15;  // after these, the interior-point method converges faster
    return Solve(rows, solving, &at).ok();
  }

  void SolveOnce() {
    ConstrainedProblem rows = RigidBodyRows(problem_, *unknowns_, options_, missed_);
    rows.start = start_;
    ConstrainedSolution at;
    RigidBodySummary& summary = plan_.summary;
    const bool by_ceres = options_.method == "ceres";
    summary.settled = by_ceres && SolveByCeres(rows, at);
    if (!by_ceres || at.violation > options_.tolerance) {
      summary.iterations += at.iterations;
      if (by_ceres) rows.start = at.x;
      summary.settled = SolveByInteriorPoint(rows, at);
      if (by_ceres && at.violation > options_.tolerance && !nodes_are_fixed_)
        not_carried_ = ReasonNotCarried(problem_, options_);
    }
    start_ = at.x;
    plan_.motion = MotionOf(problem_, *unknowns_, at.x);
    plan_.numbers = {unknowns_->nodes_s(), missed_, at.x, at.multipliers};
    summary.variables = unknowns_->size();
    summary.constraints = 0;
    for (const Constraint& c : rows.constraints) summary.constraints += static_cast<int>(c.lower.size());
    summary.iterations += at.iterations;
    summary.cost = at.cost;
    summary.violation = at.violation;
    summary.violations = at.violations;
    summary.least = at.least;
    summary.worst = at.worst_constraint;
    worst_ = static_cast<RigidBodyRowKind>(at.worst_family);
    summary.unmet = UnmetOf(at);
    summary.faults = FaultsOf(problem_, plan_.motion, 1e-3);
  }

  static constexpr double kFirstGap = 1e-2, kNextGap = 1e-4;
  const RigidBodyProblem& problem_;
  RigidBodyOptions options_;
  RigidBodyPlan plan_;
  std::optional<RigidBodyUnknowns> unknowns_;
  std::vector<MissedReach> missed_;
  VectorX start_;
  double first_gap_ = kFirstGap;
  bool nodes_are_fixed_ = false;
  RigidBodyRowKind worst_ = RigidBodyRowKind::kOther;  // of the last solve
  std::optional<Failure> not_carried_;                 // a more general reason than unmet constraints
};

}  // namespace

std::optional<Failure> ReasonNotCarried(const RigidBodyProblem& problem, const RigidBodyOptions& options) {
  CheckRigidBodyProblem(problem);
  RigidBodyOptions lenient = options;
  CheckOptions(lenient.Fields());
  lenient.turns_by_forces = false;
  lenient.force_margin = lenient.reach_margin_m = lenient.swing_lead_s = 0.0;
  RigidBodyProblem without_swings = problem;
  without_swings.swings.clear();
  if (const auto at = Infeasible(without_swings, lenient)) {
    Failure failure = Unmet(problem, static_cast<RigidBodyRowKind>(at->worst_family), UnmetOf(*at));
    failure.code = FailureCode::kNotCarried;
    failure.message = "no contact forces can move the body along its path, for any rotation: " + UnmetOf(*at) +
                      TooSteepAtGoal(problem);
    return failure;
  }
  return std::nullopt;
}

OptionFields RigidBodyOptions::Fields() {
  return WithBasics(
      {"method", "spacing_s", "max_iterations"},
      {
          {"method",
           &method,
           "",
           0.0,
           0.0,
           "Solver: an interior-point method, or at most 15 steps of an augmented Lagrangian with Ceres, followed by "
           "interior-point if constraints stay violated.",
           {"interior-point", "ceres"}},
          {"spacing_s", &spacing_s, "s", 0.005, 1.0, "Longest time between two nodes of the contact forces."},
          {"least_intervals", &least_intervals, "1", 2, 100,
           "Smallest number of intervals between force nodes in a stance."},
          {"grid_s", &grid_s, "s", 0.0, 0.1,
           "Time grid on which force nodes between contact switches lie; 0 allows any time."},
          {"friction_sides", &friction_sides, "1", 4, 64,
           "Number of sides of the pyramid that approximates the friction cone from inside."},
          {"force_margin", &force_margin, "m g", 0.0, 0.1,
           "Margin of contact forces to their bounds, in units of the robot's weight."},
          {"reach_margin_m", &reach_margin_m, "m", 0.0, 0.1, "Margin of the feet to the boundary of their workspace."},
          {"swing_lead_s", &swing_lead_s, "s", 0.0, 1.0,
           "Time before and after a stance during which its foothold must be within reach."},
          {"tolerance", &tolerance, "1", 1e-10, 1e-2,
           "Largest constraint violation that is accepted, in m, rad, rad/s and units of weight (m g)."},
          {"fault_tolerance", &fault_tolerance, "1", 1e-6, 1.0,
           "Largest constraint violation between nodes (checked at 1 kHz, in m and m g) that needs no refinement."},
          {"max_refinements", &max_refinements, "1", 0, 10,
           "Maximum number of refinements, each of which halves the node spacing or adds reach checks."},
          {"cost_tolerance", &cost_tolerance, "1", 1e-10, 1.0,
           "Relative change of the cost below which the solve has converged."},
          {"penalty", &penalty, "1", 1e-3, 1e6,
           "Initial penalty weight on constraint violation, in units of half the cost."},
          {"max_penalty", &max_penalty, "1", 1e-3, 1e6,
           "Maximum penalty weight on constraint violation, in units of half the cost."},
          {"screening", &early_check, "1", 1, 10000,
           "Iterations of the early infeasibility check: after these the solve stops if violations exceed "
           "`infeasible`."},
          {"infeasible", &infeasible, "1", 0.0, 1e6,
           "Sum of constraint violations above which a solve is stopped as infeasible after `screening` iterations."},
          {"max_iterations", &max_iterations, "1", 1, 10000, "Maximum number of iterations of a solve."},
          {"force_rate", &weights.force_rate, "s", 0.0, 1e3,
           "Cost weight of the squared rate of the contact forces (in m g)."},
          {"momentum", &weights.momentum, "s", 0.0, 1e3,
           "Cost weight of the squared angular momentum divided by the mean inertia."},
          {"tilt", &weights.tilt, "1/(rad^2 s)", 0.0, 1e3,
           "Cost weight of the squared deviation of the base's orientation from level and its wanted heading."},
          {"stance", &weights.stance, "1/(m^2 s)", 0.0, 1e6,
           "Cost weight of the squared distance of stance feet from their nominal positions."},
          {"path", &weights.path, "1/(m^2 s)", 0.0, 1e3,
           "Cost weight of the squared lateral deviation of the centre of mass from its path."},
          {"swing_jerk", &weights.swing_jerk, "1/m^2", 0.0, 1e3,
           "Cost weight of the squared jerk of swings whose path is free."},
      });
}

Result<RigidBodyPlan> PlanRigidBody(const RigidBodyProblem& problem, const RigidBodyOptions& options,
                                    RigidBodyPlan* last) {
  CheckRigidBodyProblem(problem);
  RigidBodyOptions checked = options;
  CheckOptions(checked.Fields());
  RigidBodyPlanner planner(problem, checked);
  Result<RigidBodyPlan> plan = planner.Run();
  if (last != nullptr) *last = planner.plan();
  return plan;
}

Result<RigidBodyPlan> PlanRigidBodyFrom(const RigidBodyProblem& problem, const RigidBodyOptions& options,
                                        const RigidBodyNumbers& from, RigidBodyPlan* last) {
  CheckRigidBodyProblem(problem);
  RigidBodyOptions checked = options;
  CheckOptions(checked.Fields());
  RigidBodyPlanner planner(problem, checked);
  Result<RigidBodyPlan> plan = planner.RunFrom(from);
  if (last != nullptr) *last = planner.plan();
  return plan;
}

}  // namespace gaitwright
