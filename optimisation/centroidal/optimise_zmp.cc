// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/centroidal/optimise_zmp.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "kinematics/base/non_finite.h"
#include "optimisation/centroidal/zmp_knots.h"
#include "optimisation/numerics/constrained_problem.h"

namespace gaitwright {
namespace {

/// value = A x - b.
VectorFunction Linear(MatrixX A, VectorX b) {
  return [A = std::move(A), b = std::move(b)](const VectorX& x, VectorX& value, MatrixX* J) {
    value = -b;
    value.noalias() += A * x;
    if (J != nullptr) *J = A;
  };
}

std::vector<int> Numbered(int first, int size) {
  std::vector<int> variables(static_cast<std::size_t>(size));
  std::iota(variables.begin(), variables.end(), first);
  return variables;
}

std::vector<int> VariablesOf(const ZmpKnot& knot) { return Numbered(knot.first, knot.size); }

/// Assembles the problem of the knots' variables. The names of constraints are texts for failures with a placeholder
/// for mm.
class Assembler {
 public:
  Assembler(const ZmpProblem& problem, const ZmpWeights& weights, const ZmpKnots& zmp)
      : problem_(problem), weights_(weights), zmp_(zmp) {}

  ConstrainedProblem Run(const std::vector<Vector2>& guess) {
    Start(guess);
    AddCentring();
    for (const auto& [left, right] : zmp_.spans) AddSmoothing(zmp_.knots[left], zmp_.knots[right]);
    for (const ZmpKnot& knot : zmp_.knots) AddRegion(knot);
    AddEnds();
    return std::move(out_);
  }

 private:
  std::string PhaseText(std::size_t i) const {
    return fmt::format("phase {} ({:.2f} to {:.2f} s)", i, problem_.phases[i].start_s, problem_.phases[i].end_s);
  }

  void Start(const std::vector<Vector2>& guess) {
    out_.start = VectorX::Zero(zmp_.num_variables);
    for (const ZmpKnot& knot : zmp_.knots) {
      if (knot.size == 0) continue;
      const auto k = static_cast<std::size_t>(std::lround((knot.time_s - problem_.start_s) / problem_.step_s));
      const Vector2 p = NearestPoint(knot.region_W, guess[std::min(k, guess.size() - 1)]);
      const MatrixX basis = knot.basis.leftCols(knot.size);
      out_.start.segment(knot.first, knot.size) =
          (basis.transpose() * basis).diagonal().cwiseInverse().asDiagonal() * basis.transpose() * (p - knot.origin_W);
    }
  }

  /// A knot represents half of each straight piece beside it.
  void AddCentring() {
    std::vector<double> time_s(zmp_.knots.size(), 0.0);
    for (const auto& [left, right] : zmp_.spans) {
      const double half_s = 0.5 * (zmp_.knots[right].time_s - zmp_.knots[left].time_s);
      time_s[left] += half_s;
      time_s[right] += half_s;
    }
    for (std::size_t j = 0; j < zmp_.knots.size(); ++j) {
      const ZmpKnot& knot = zmp_.knots[j];
      if (knot.size == 0) continue;
      const double root = std::sqrt(weights_.centre * time_s[j]);
      const Vector2 wanted = PreferredAt(problem_.phases[knot.phase], knot.time_s) - knot.origin_W;
      out_.residuals.push_back({Linear(root * knot.basis.leftCols(knot.size), root * wanted), VariablesOf(knot)});
    }
  }

  void AddSmoothing(const ZmpKnot& left, const ZmpKnot& right) {
    if (left.size + right.size == 0 || weights_.smooth == 0.0) return;
    const double root = std::sqrt(weights_.smooth / (right.time_s - left.time_s));
    MatrixX A(2, left.size + right.size);
    A << -root * left.basis.leftCols(left.size), root * right.basis.leftCols(right.size);
    std::vector<int> variables = VariablesOf(left);
    const std::vector<int> others = VariablesOf(right);
    variables.insert(variables.end(), others.begin(), others.end());
    out_.residuals.push_back({Linear(A, root * (left.origin_W - right.origin_W)), variables});
  }

  /// Distance to each edge, or the fraction of the line.
  void AddRegion(const ZmpKnot& knot) {
    if (knot.size == 0) return;
    const Polygon& region = knot.region_W;
    const bool line = region.size() == 2;
    const auto rows = static_cast<Eigen::Index>(line ? 1 : region.size());
    MatrixX normals(rows, 2);
    VectorX lower(rows), upper = VectorX::Constant(rows, kInfinity);
    for (Eigen::Index i = 0; i < rows; ++i) {
      const auto at = static_cast<std::size_t>(i);
      const Vector2 edge = region[(at + 1) % region.size()] - region[at];
      const Vector2 along = line ? Vector2(knot.basis.col(0).normalized()) : edge.normalized();
      normals.row(i) = line ? along : Vector2(-along.y(), along.x());
      lower[i] = normals.row(i) * region[at];
      if (line) upper[i] = normals.row(i) * region[1];
    }
    const MatrixX A = normals * knot.basis.leftCols(knot.size);
    const VectorX b = -normals * knot.origin_W;
    out_.constraints.push_back({fmt::format("in {}, the ZMP at {:.2f} s would be {{:.1f}} mm outside its support",
                                            PhaseText(knot.phase), knot.time_s),
                                Linear(A, b), lower, upper, VariablesOf(knot)});
  }

  /// Rest at both ends, x and y.
  void AddEnds() {
    const EndResponse response = RespondAtEnds(problem_);
    const Vector2 start = problem_.start_W - response.dcm_start_by_end * problem_.end_W;
    const Vector2 end = (1.0 - response.com_end_by_end) * problem_.end_W - response.com_end_by_start * problem_.start_W;
    AddEnd(fmt::format("in {}, the ZMP misses a start of the pendulum at rest by {{:.1f}} mm", PhaseText(0)),
           response.dcm_start, start);
    AddEnd(fmt::format("in {}, the ZMP misses an end of the pendulum at rest by {{:.1f}} mm",
                       PhaseText(problem_.phases.size() - 1)),
           response.com_end, end);
  }

  void AddEnd(const std::string& name, const std::vector<double>& response, Vector2 wanted) {
    constexpr double kNothing = 1e-9;
    MatrixX by_variable = MatrixX::Zero(2, zmp_.num_variables);
    for (std::size_t k = 0; k < response.size(); ++k) {
      const ZmpBlend& sample = zmp_.samples[k];
      wanted -= response[k] * (sample.constant_W - problem_.zmp_offset[k]);
      const auto add = [&](const ZmpKnot& knot, const Eigen::Matrix2d& by_knot) {
        wanted -= response[k] * by_knot * knot.origin_W;
        by_variable.middleCols(knot.first, knot.size) += response[k] * by_knot * knot.basis.leftCols(knot.size);
      };
      add(zmp_.knots[sample.left], sample.by_left);
      add(zmp_.knots[sample.right], sample.by_right);
    }
    std::vector<int> variables;
    for (int v = 0; v < zmp_.num_variables; ++v) {
      if (by_variable.col(v).cwiseAbs().maxCoeff() >= kNothing) variables.push_back(v);
    }
    if (variables.empty()) variables = Numbered(0, zmp_.num_variables);
    out_.constraints.push_back(
        {name, Linear(by_variable(Eigen::all, variables), VectorX::Zero(2)), wanted, wanted, variables});
  }

  const ZmpProblem& problem_;
  const ZmpWeights& weights_;
  const ZmpKnots& zmp_;
  ConstrainedProblem out_;
};

/// Moves each knot exactly into its region; the solver only reaches its tolerance.
VectorX Clamped(const ZmpKnots& zmp, VectorX x) {
  for (const ZmpKnot& knot : zmp.knots) {
    const Vector2 p = knot.At(x), inside = knot.size == 0 ? p : NearestPoint(knot.region_W, p);
    if (knot.size == 2) x.segment(knot.first, 2) += inside - p;
    if (knot.size == 1) x[knot.first] += knot.basis.col(0).dot(inside - p) / knot.basis.col(0).squaredNorm();
  }
  return x;
}

}  // namespace

Result<OptimisedZmp> OptimiseZmp(const ZmpProblem& problem, const ZmpWeights& weights,
                                 const std::vector<Vector2>& guess) {
  const Result<ZmpKnots> zmp = PlaceZmpKnots(problem, weights.margin_m, weights.knot_spacing_s);
  if (!zmp) return zmp.failure();
  if (zmp->num_variables == 0) return OptimisedZmp{zmp->Sample(VectorX()), zmp->Margins(), 0, "no choice"};
  ConstrainedOptions options;
  options.tolerance = 1e-9;
  options.cost_tolerance = 1e-9;
  options.trust_radius = 1e8;
  ConstrainedSolution last;
  const Result<ConstrainedSolution> solution = Solve(Assembler(problem, weights, *zmp).Run(guess), options, &last);
  if (!solution && last.violation > options.tolerance) {
    return Failure{FailureKind::kInfeasible,
                   FailureCode::kZmpSupport,
                   "PlanCentreOfMass",
                   fmt::format(fmt::runtime(last.worst_constraint), 1e3 * last.violation),
                   {"stand longer at the start and end, or use shorter or slower steps"},
                   Violation{Law::kZmpSupport, std::nan(""), "zero-moment point", last.violation, 0.0, "m"}};
  }
  return OptimisedZmp{zmp->Sample(Clamped(*zmp, last.x)), zmp->Margins(), zmp->num_variables, last.brief};
}

}  // namespace gaitwright
