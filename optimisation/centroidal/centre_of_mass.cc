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

/// A bump over an interval, by sample of the grid.
std::vector<double> BumpOver(const ZmpProblem& problem, double start_s, double end_s) {
  std::vector<double> bump(static_cast<std::size_t>(problem.samples));
  for (std::size_t k = 0; k < bump.size(); ++k) {
    const double t = problem.start_s + static_cast<double>(k) * problem.step_s;
    bump[k] = SmoothBump((t - start_s) / (end_s - start_s)).value;
  }
  return bump;
}

/// Moves the ZMP by two bumps, so that the DCM starts at the resting CoM and the CoM ends at its goal. One bump is in
/// the first phase, one in the last; a single phase is halved. The DCM and the CoM are linear in the ZMP.
void MeetEnds(const ZmpProblem& problem, std::vector<Vector2>& p_WZ) {
  const ZmpPhase &head = problem.phases.front(), &tail = problem.phases.back();
  const double middle_s = 0.5 * (head.start_s + head.end_s);
  const bool only_one = problem.phases.size() == 1;
  const std::vector<double> first = BumpOver(problem, head.start_s, only_one ? middle_s : head.end_s);
  const std::vector<double> last = BumpOver(problem, only_one ? middle_s : tail.start_s, tail.end_s);
  const EndResponse ends = RespondAtEnds(problem);
  Eigen::Matrix2d response = Eigen::Matrix2d::Zero();  // rows: DCM at the start, CoM at the end
  Vector2 dcm = ends.dcm_start_by_end * problem.end_W;
  Vector2 com = ends.com_end_by_start * problem.start_W + ends.com_end_by_end * problem.end_W;
  for (std::size_t k = 0; k < p_WZ.size(); ++k) {
    const Vector2 input = p_WZ[k] - problem.zmp_offset[k];
    dcm += ends.dcm_start[k] * input;
    com += ends.com_end[k] * input;
    response += Vector2(ends.dcm_start[k], ends.com_end[k]) * Eigen::RowVector2d(first[k], last[k]);
  }
  Eigen::Matrix2d missing;  // columns: x, y
  missing << (problem.start_W - dcm).transpose(), (problem.end_W - com).transpose();
  const Eigen::Matrix2d moved = response.inverse() * missing;
  for (std::size_t k = 0; k < p_WZ.size(); ++k) p_WZ[k] += (Eigen::RowVector2d(first[k], last[k]) * moved).transpose();
}

/// The preferred points, corrected so that both ends are at rest.
std::vector<Vector2> ClosedFormZmp(const ZmpProblem& problem) {
  std::vector<Vector2> p_WZ;
  for (int k = 0; k < problem.samples; ++k) {
    const double t = problem.start_s + k * problem.step_s;
    p_WZ.push_back(PreferredAt(problem.phases[ZmpPhaseAt(problem, t)], t));
  }
  MeetEnds(problem, p_WZ);
  return p_WZ;
}

/// The motion for a ZMP; a failure if the ZMP leaves its supports.
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
    if (lacking > worst + (worst > 0.0 ? kRounding : 0.0)) {  // the first one of equals
      worst = lacking;
      worst_s = t;
    }
  }
  if (worst > 0.0) {
    return Failure{FailureKind::kInfeasible,
                   FailureCode::kZmpSupport,
                   "PlanCentreOfMass",
                   fmt::format("in phase {}, the ZMP at {:.2f} s would be {:.1f} mm outside its support",
                               ZmpPhaseAt(problem, worst_s), worst_s, 1e3 * worst),
                   {"stand longer at the start and end, or use shorter or slower steps"},
                   Violation{Law::kZmpSupport, worst_s, "zero-moment point", worst, 0.0, "m"}};
  }
  plan.trajectory = PendulumMotion(problem, p_WZ);
  plan.summary = fmt::format("{} samples, smallest ZMP margin {:.1f} mm", problem.samples, 1e3 * plan.margin_min_m);
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
