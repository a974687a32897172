// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/centroidal/centre_of_mass.h"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "kinematics/trajectory/swing_curve.h"
#include "optimisation/centroidal/optimise_zmp.h"
#include "optimisation/centroidal/preview_zmp.h"

namespace gaitwright {
namespace {

/// Moves the ZMP by two bumps, one in the first phase and one in the last, so that the DCM starts on the resting CoM
/// and the CoM ends at its goal. Both are linear in the ZMP, so two unit responses tell how far.
void MeetEnds(const ZmpProblem& problem, std::vector<Vector2>& p_WZ) {
  const auto n = static_cast<std::size_t>(problem.samples);
  std::vector<double> first(n), last(n);
  const ZmpPhase &head = problem.phases.front(), &tail = problem.phases.back();
  for (std::size_t k = 0; k < n; ++k) {
    const double t = problem.start_s + static_cast<double>(k) * problem.step_s;
    first[k] = SmoothBump((t - head.start_s) / (head.end_s - head.start_s)).value;
    last[k] = SmoothBump((t - tail.start_s) / (tail.end_s - tail.start_s)).value;
  }
  const auto ends = [&](const std::vector<Vector2>& p) {
    const CentroidalTrajectory motion = PendulumMotion(problem, p);
    // Velocity at the start stands for the DCM's error there.
    return std::pair<Vector2, Vector2>(motion.v_WC.front().head<2>(), motion.p_WC.back().head<2>());
  };
  const std::pair<Vector2, Vector2> unmoved = ends(p_WZ);
  const Vector2 &v0 = unmoved.first, &c1 = unmoved.second;
  const auto moved = [&](const std::vector<double>& bump) {
    std::vector<Vector2> p = p_WZ;
    for (std::size_t k = 0; k < n; ++k) p[k] += bump[k] * Vector2::Ones();
    const auto [v, c] = ends(p);
    return Vector2((v - v0).x(), (c - c1).x());
  };
  Eigen::Matrix2d response;
  response << moved(first), moved(last);
  const Eigen::Matrix2d inverse = response.inverse();
  const Vector2 missing = problem.end_W - c1;
  const Vector2 x = inverse * Vector2(-v0.x(), missing.x()), y = inverse * Vector2(-v0.y(), missing.y());
  for (std::size_t k = 0; k < n; ++k)
    p_WZ[k] += Vector2(x[0] * first[k] + x[1] * last[k], y[0] * first[k] + y[1] * last[k]);
}

/// The preferred points with their ends met.
std::vector<Vector2> ClosedFormZmp(const ZmpProblem& problem) {
  std::vector<Vector2> p_WZ;
  for (int k = 0; k < problem.samples; ++k) {
    const double t = problem.start_s + k * problem.step_s;
    p_WZ.push_back(PreferredAt(problem.phases[ZmpPhaseAt(problem, t)], t));
  }
  MeetEnds(problem, p_WZ);
  return p_WZ;
}

/// The motion under a ZMP, when that keeps to its supports.
Result<CentreOfMassPlan> Checked(const ZmpProblem& problem, const std::vector<Vector2>& p_WZ,
                                 const std::vector<double>& margin_m) {
  constexpr double kRounding = 1e-6;
  CentreOfMassPlan plan;
  plan.margin_min_m = std::numeric_limits<double>::infinity();
  double worst = 0.0, worst_s = 0.0;
  for (int k = 0; k < problem.samples; ++k) {
    const double t = problem.start_s + k * problem.step_s;
    const Polygon region = RegionAt(problem.phases[ZmpPhaseAt(problem, t)], t);
    const double inside = SignedDistance(region, p_WZ[static_cast<std::size_t>(k)]);
    const bool has_area = region.size() >= 3;
    if (has_area) plan.margin_min_m = std::min(plan.margin_min_m, inside);
    const double lacking = (has_area ? margin_m[static_cast<std::size_t>(k)] : 0.0) - kRounding - inside;
    if (lacking > worst) {
      worst = lacking;
      worst_s = t;
    }
  }
  if (worst > 0.0) {
    return Failure{FailureKind::kInfeasible,
                   "zmp_support",
                   "PlanCentreOfMass",
                   fmt::format("in phase {} the ZMP would at {:.2f} s be {:.1f} mm outside its support",
                               ZmpPhaseAt(problem, worst_s), worst_s, 1e3 * worst),
                   {"stand longer at the ends, or take smaller or slower steps"}};
  }
  plan.trajectory = PendulumMotion(problem, p_WZ);
  plan.summary = fmt::format("{} samples, least ZMP margin {:.1f} mm", problem.samples, 1e3 * plan.margin_min_m);
  return plan;
}

}  // namespace

Result<CentreOfMassPlan> PlanCentreOfMass(const ZmpProblem& problem, const CentreOfMassOptions& options) {
  CentreOfMassOptions checked = options;
  CheckOptions(checked.Fields());
  const std::vector<Vector2> closed_form = ClosedFormZmp(problem);
  const std::vector<double> margin_m(closed_form.size(), options.zmp_margin_m);
  if (options.method == "closed-form") return Checked(problem, closed_form, margin_m);
  if (options.method == "preview") {
    std::vector<Vector2> followed = PreviewZmp(problem, {options.preview_s, options.preview_jerk_weight});
    MeetEnds(problem, followed);
    return Checked(problem, followed, margin_m);
  }
  const ZmpWeights weights{options.centre_weight, options.smooth_weight, options.zmp_margin_m, options.knot_spacing_s};
  const Result<OptimisedZmp> optimised = OptimiseZmp(problem, weights, closed_form);
  if (!optimised) {
    const Result<CentreOfMassPlan> fallback = Checked(problem, closed_form, margin_m);
    return fallback ? fallback : Result<CentreOfMassPlan>(optimised.failure());
  }
  Result<CentreOfMassPlan> plan = Checked(problem, optimised->p_WZ, optimised->margin_m);
  if (plan) plan->summary += fmt::format("; {} variables, {}", optimised->variables, optimised->brief);
  return plan;
}

}  // namespace gaitwright
