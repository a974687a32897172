// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/centroidal/plan_rigid_body.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "kinematics/spatial/rotation.h"
#include "optimisation/centroidal/hold_goal.h"
#include "optimisation/centroidal/rigid_body_terms.h"
#include "optimisation/centroidal/rigid_body_unknowns.h"
#include "optimisation/numerics/elastic_interior.h"

namespace gaitwright {
namespace {

/// The times at which a stance's foot must be within reach: at breaks, half way between them, and as long before
/// touch-down and after lift-off as it is as good as there.
std::vector<double> ReachTimes(const RigidStance& stance, const std::vector<double>& breaks, double lead_s) {
  constexpr double kSame = 1e-4;
  std::vector<double> times;
  for (std::size_t k = 0; k < breaks.size(); ++k) {
    if (breaks[k] < stance.start_s - kSame || breaks[k] > stance.end_s + kSame) continue;
    times.push_back(breaks[k]);
    if (k + 1 < breaks.size() && breaks[k + 1] < stance.end_s + kSame)
      times.push_back(0.5 * (breaks[k] + breaks[k + 1]));
  }
  if (stance.start_s - lead_s > 0.0) times.push_back(stance.start_s - lead_s);
  if (stance.end_s + lead_s < breaks.back()) times.push_back(stance.end_s + lead_s);
  return times;
}

/// A stance and a time at which its foot is out of reach between those at which it was looked at.
struct MissedReach {
  std::size_t stance;
  double time_s;
};

/// Where feet are farthest out of reach by more than `tolerance_m` at 1 kHz, each stance's worst.
std::vector<MissedReach> MissedReaches(const RigidBodyProblem& problem, const RigidBodyMotion& motion,
                                       double tolerance_m) {
  std::vector<double> worst(problem.stances.size(), tolerance_m), at(worst.size(), -1.0);
  for (const RigidBodySample& sample : Sample(motion, 1e-3)) {
    const Matrix3 R_BW = RotationOf(sample.angles_rad).transpose();
    for (const RigidBodyInterval::Force& f : motion.intervals[sample.interval].forces) {
      const RigidFoot& foot = problem.feet[static_cast<std::size_t>(problem.stances[f.stance].foot)];
      const Vector3 p_B = R_BW * (motion.X_WF[f.stance].translation() - sample.p_WC);
      for (const WorkspaceSide& side : foot.workspace_B) {
        const double out = side.normal.dot(p_B) - side.offset;
        if (out <= worst[f.stance]) continue;
        worst[f.stance] = out;
        at[f.stance] = sample.time_s;
      }
    }
  }
  std::vector<MissedReach> missed;
  for (std::size_t s = 0; s < at.size(); ++s) {
    if (at[s] >= 0.0) missed.push_back({s, at[s]});
  }
  return missed;
}

/// The problem as rows over its unknowns.
ConstrainedProblem Rows(const RigidBodyProblem& problem, const RigidBodyUnknowns& unknowns,
                        const RigidBodyOptions& options, const std::vector<MissedReach>& missed) {
  const RigidBodyTerms terms(problem, unknowns);
  ConstrainedProblem rows;
  // What depends on no unknown is given, and nothing to be solved for.
  const auto add = [&](Constraint constraint) {
    if (!constraint.variables.empty()) rows.constraints.push_back(std::move(constraint));
  };
  for (std::size_t i = 0; i < unknowns.intervals(); ++i) add(terms.Turning(i));
  for (const std::size_t k : unknowns.FreeBreaks()) add(terms.Free(k));
  const std::vector<BoundForce>& forces = unknowns.BoundForces();
  for (const BoundForce& force : forces) add(terms.Friction(force, options.friction_sides, options.force_margin));
  for (auto from = forces.begin(); from != forces.end();) {
    const auto to = std::find_if(from, forces.end(), [&](const BoundForce& f) {
      return f.stance != from->stance || f.at_break != from->at_break;
    });
    if (problem.stances[from->stance].MotorsAt(0.0) != nullptr) add(terms.Motors({from, to}));
    from = to;
  }
  for (std::size_t s = 0; s < problem.stances.size(); ++s) {
    for (const double t : ReachTimes(problem.stances[s], unknowns.breaks_s(), options.swing_lead_s))
      add(terms.Reach(s, t, options.reach_margin_m));
  }
  for (const RigidSwing& swing : problem.swings) {
    for (const double share : {0.1, 0.2, 0.35, 0.5, 0.65, 0.8, 0.9})
      add(terms.SwingReach(swing, share, options.reach_margin_m));
  }
  for (const MissedReach& m : missed) add(terms.Reach(m.stance, m.time_s, options.reach_margin_m));
  for (std::size_t s = 0; s < problem.stances.size(); ++s) {
    if (!problem.stances[s].held && !problem.stances[s].region_F.empty()) add(terms.Region(s));
  }
  rows.residuals = RigidBodyCost(problem, unknowns, options.weights);
  return rows;
}

/// Where the body would be with the feet where they like to stand below it: the mean over the feet on the ground.
Vector3 GuessCentreOfMass(const RigidBodyProblem& problem, double time_s) {
  Vector3 sum = Vector3::Zero();
  double weights = 0.0;
  const Matrix3 heading = YawRotation(WantedAngles(problem, time_s).z());
  for (std::size_t f = 0; f < problem.feet.size(); ++f) {
    const RigidStance *before = nullptr, *after = nullptr;
    for (const RigidStance& stance : problem.stances) {
      if (stance.foot != static_cast<int>(f)) continue;
      if (stance.start_s <= time_s) before = &stance;
      if (after == nullptr && stance.end_s >= time_s) after = &stance;
    }
    if (before == nullptr) before = after;
    if (after == nullptr) after = before;
    if (before == nullptr) continue;
    const double span = after->start_s - before->end_s;
    const double u = before == after || span <= 0.0 ? 0.0 : std::clamp((time_s - before->end_s) / span, 0.0, 1.0);
    const Vector3 p = (1.0 - u) * before->X_WF.translation() + u * after->X_WF.translation();
    sum += p - heading * problem.feet[f].p_CF_nominal_B;
    weights += 1.0;
  }
  return sum / weights;
}

Vector3 GuessPlace(const RigidBodyProblem& problem, double t) {
  return problem.way.time_s.empty() ? GuessCentreOfMass(problem, t) : problem.way.PlaceAt(t);
}

Vector3 GuessAngles(const RigidBodyProblem& problem, double t) {
  return problem.way.time_s.empty() ? WantedAngles(problem, t) : problem.way.AnglesAt(t);
}

VectorX Guess(const RigidBodyProblem& problem, const RigidBodyUnknowns& unknowns) {
  VectorX x = VectorX::Zero(unknowns.size());
  const std::vector<double>& t = unknowns.breaks_s();
  // A control point belongs to the mean of the three knots that it stands over: Greville's abscissa.
  const auto knot = [&](std::size_t j) { return t[std::clamp<std::size_t>(j, 3, t.size() + 2) - 3]; };
  for (std::size_t i = 2; i < t.size(); ++i) {
    const int place = unknowns.ControlPoint(i);
    if (place >= 0) x.segment<3>(place) = GuessPlace(problem, (knot(i + 1) + knot(i + 2) + knot(i + 3)) / 3.0);
  }
  for (std::size_t k = 1; k + 1 < t.size(); ++k) {
    const std::vector<AffineVector::Part>& angles = unknowns.Angles(k).parts;
    if (!angles.empty()) x.segment<3>(angles.front().start) = GuessAngles(problem, t[k]);
  }
  std::vector<int> sharing(t.size(), 0);
  for (const BoundForce& force : unknowns.BoundForces()) ++sharing[force.at_break];
  for (const BoundForce& force : unknowns.BoundForces()) {
    const std::vector<AffineVector::Part>& parts = force.force.parts;
    if (parts.size() == 1 && parts.front().coefficient == 1.0)
      x[parts.front().start + 2] = 1.0 / sharing[force.at_break];
  }
  return x;
}

/// Where no forces on the footholds at the goal can hold a body there; else nothing.
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
      "; at the goal all feet are on ground that takes a friction of {:.2f} to hold still on, and has {:.2f}", needed,
      friction);
}

/// The worst three that are violated, and all of it.
std::string UnmetOf(const ConstrainedSolution& at) {
  std::string unmet;
  for (std::size_t i = 0; i < std::min<std::size_t>(3, at.unmet.size()); ++i)
    unmet += fmt::format("{}{}{} by {:.3g}", i == 0 ? "" : ", ", at.unmet[i].first, i == 0 ? " stays unmet" : "",
                         at.unmet[i].second);
  return fmt::format("{}{} after {} iterations; {:.3g} in all{}", unmet, at.unmet.size() > 3 ? " and more" : "",
                     at.iterations, at.violations, at.least ? ", which small changes of the motion do not lower" : "");
}

Failure Unmet(const RigidBodyProblem& problem, const RigidBodySummary& summary) {
  return {FailureKind::kInfeasible,
          "unmet_law",
          "PlanRigidBody",
          "no motion was found that keeps all laws: " + summary.unmet + TooSteepAtGoal(problem),
          {"give it more time or a nearer goal, or footholds elsewhere"}};
}

Failure FaultsBetween(const RigidBodySummary& summary) {
  return {FailureKind::kInfeasible,
          "faults_between",
          "PlanRigidBody",
          fmt::format("between breaks a law is broken by {:.3g} though they were put half as far apart {} times",
                      summary.faults.Largest(), summary.refinements),
          {"raise max_refinements or reach_margin_m"}};
}

/// Plans over breaks that are put nearer to each other, and feet looked at more often, where that is needed.
class RigidBodyPlanner {
 public:
  RigidBodyPlanner(const RigidBodyProblem& problem, const RigidBodyOptions& options)
      : problem_(problem), options_(options) {}

  Result<RigidBodyPlan> Run() {
    SetBreaks();
    while (true) {
      SolveOnce();
      RigidBodySummary& summary = plan_.summary;
      if (summary.violation > options_.tolerance) return Unmet(problem_, summary);
      if (summary.faults.Largest() <= options_.fault_tolerance) return plan_;
      if (summary.refinements == options_.max_refinements) return FaultsBetween(summary);
      ++summary.refinements;
      if (!LookCloser()) {
        options_.spacing_s *= 0.5;
        options_.least_intervals *= 2;
        SetBreaks();
      }
    }
  }

  const RigidBodyPlan& plan() const { return plan_; }

 private:
  void SetBreaks() {
    unknowns_.emplace(problem_, options_.spacing_s, options_.least_intervals, options_.grid_s);
    missed_.clear();
    start_ = Guess(problem_, *unknowns_);
    first_gap_ = kFirstGap;
  }

  /// Where reach alone is missed, at what times. @return false where other laws are.
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
    solving.price = options_.price;
    solving.most_price = options_.most_price;
    solving.first_gap = first_gap_;
    solving.screening = options_.screening;
    solving.hopeless = options_.hopeless;
    solving.max_iterations = options_.max_iterations;
    return SolveElastic(rows, solving, &at).ok();
  }

  bool SolveByCeres(const ConstrainedProblem& rows, ConstrainedSolution& at) const {
    ConstrainedOptions solving;
    solving.tolerance = options_.tolerance;
    solving.cost_tolerance = options_.cost_tolerance;
    solving.stiffness = 300.0;
    solving.trust_radius = 1e7;
    solving.inner_tolerance = 1e-4;
    solving.patience = 5;
    solving.max_outer = 25;
    solving.max_inner = 40;
    return Solve(rows, solving, &at).ok();
  }

  void SolveOnce() {
    ConstrainedProblem rows = Rows(problem_, *unknowns_, options_, missed_);
    rows.start = start_;
    ConstrainedSolution at;
    RigidBodySummary& summary = plan_.summary;
    summary.settled = options_.method == "ceres" && SolveByCeres(rows, at);
    if (options_.method == "ceres" && at.violation > options_.tolerance) {
      summary.iterations += at.iterations;
      rows.start = at.x;
    }
    if (options_.method != "ceres" || at.violation > options_.tolerance)
      summary.settled = SolveByInteriorPoint(rows, at);
    start_ = at.x;
    plan_.motion = MotionOf(problem_, *unknowns_, at.x);
    summary.variables = unknowns_->size();
    summary.constraints = 0;
    for (const Constraint& c : rows.constraints) summary.constraints += static_cast<int>(c.lower.size());
    summary.iterations += at.iterations;
    summary.cost = at.cost;
    summary.violation = at.violation;
    summary.violations = at.violations;
    summary.least = at.least;
    summary.worst = at.worst_constraint;
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
};

}  // namespace

OptionFields RigidBodyOptions::Fields() {
  return {
      {"method",
       &method,
       "",
       0.0,
       0.0,
       "How constraints are kept: by an interior-point method, or by an augmented Lagrangian over Ceres, after which "
       "the former is tried where some are not.",
       {"interior-point", "ceres"}},
      {"spacing_s", &spacing_s, "s", 0.005, 1.0, "Most between two breaks of forces.", {}},
      {"least_intervals", &least_intervals, "1", 2, 100, "Least intervals between breaks in a stance.", {}},
      {"grid_s", &grid_s, "s", 0.0, 0.1, "Breaks between switches of contact are at multiples of it; 0: anywhere.", {}},
      {"friction_sides", &friction_sides, "1", 4, 64, "Sides of the pyramid inside a cone of friction.", {}},
      {"force_margin", &force_margin, "m g", 0.0, 0.1, "By which forces are kept from their bounds.", {}},
      {"reach_margin_m", &reach_margin_m, "m", 0.0, 0.1, "By which feet are kept inside their workspace.", {}},
      {"swing_lead_s", &swing_lead_s, "s", 0.0, 1.0, "How long beyond a stance its foothold must be within reach.", {}},
      {"tolerance", &tolerance, "1", 1e-10, 1e-2, "Largest violation of a law, in m, rad, rad/s and m g.", {}},
      {"fault_tolerance", &fault_tolerance, "1", 1e-6, 1.0, "Largest fault at 1 kHz, in m and m g, not refined.", {}},
      {"max_refinements", &max_refinements, "1", 0, 10, "Most times that breaks are put half as far apart.", {}},
      {"cost_tolerance", &cost_tolerance, "1", 1e-10, 1.0, "Relative change of the cost that counts as none.", {}},
      {"price", &price, "1", 1e-3, 1e6, "First price of a law's violation, in half the cost.", {}},
      {"most_price", &most_price, "1", 1e-3, 1e6, "Greatest price of a law's violation.", {}},
      {"screening", &screening, "1", 1, 10000, "Steps after which a hopeless solve is given up.", {}},
      {"hopeless", &hopeless, "1", 0.0, 1e6, "Sum of violations that is hopeless after so many steps.", {}},
      {"max_iterations", &max_iterations, "1", 1, 10000, "Most steps of a solve.", {}},
      {"force_rate", &weights.force_rate, "s", 0.0, 1e3, "Weight of the rate of forces.", {}},
      {"momentum", &weights.momentum, "s", 0.0, 1e3, "Weight of the angular momentum.", {}},
      {"tilt", &weights.tilt, "1/(rad^2 s)", 0.0, 1e3, "Weight of the base's angles.", {}},
      {"stance", &weights.stance, "1/(m^2 s)", 0.0, 1e3, "Weight of the feet's places.", {}},
  };
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

}  // namespace gaitwright
