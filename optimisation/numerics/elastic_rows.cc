// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "optimisation/numerics/check_problem.h"
#include "optimisation/numerics/elastic_rows_internal.h"
#include "optimisation/numerics/sparse_rows.h"

namespace gaitwright {
namespace {

/// The rows of a problem that is given by functions.
class RowsOfProblem : public ElasticRows {
 public:
  explicit RowsOfProblem(const ConstrainedProblem& problem) : rows_(problem) {
    for (const Constraint& c : problem.constraints) {
      for (Eigen::Index i = 0; i < c.lower.size(); ++i) bounds_.push_back({c.lower[i], c.upper[i]});
    }
  }

  Eigen::Index count() const override { return rows_.count(); }
  Eigen::Index residuals() const override { return rows_.residuals(); }
  const VectorX& value() const override { return rows_.value(); }
  RowBounds BoundsOf(Eigen::Index row) const override {
    return bounds_[static_cast<std::size_t>(row - rows_.residuals())];
  }
  std::string NameOf(Eigen::Index row) const override { return rows_.ConstraintOf(row)->name; }
  int FamilyOf(Eigen::Index row) const override { return rows_.ConstraintOf(row)->family; }
  void Evaluate(const VectorX& x) override { rows_.Evaluate(x); }
  void Differentiate() override { rows_.Differentiate(); }
  VectorX Gradient(const VectorX& by) const override { return rows_.Gradient(by); }
  VectorX Moved(const VectorX& by) const override { return rows_.Moved(by); }
  bool Factor(const VectorX& weights, double damping) override { return rows_.Factor(weights, damping); }
  VectorX Solved(const VectorX& right) const override { return rows_.Solved(right); }

 private:
  SparseRows rows_;
  std::vector<RowBounds> bounds_;
};

}  // namespace

OptionFields ElasticOptions::Fields() {
  return {
      {"tolerance", &tolerance, "1", 1e-14, 1.0, "Largest constraint violation that is accepted."},
      {"cost_tolerance", &cost_tolerance, "1", 1e-14, 1.0,
       "Relative change of the cost below which the solve has converged."},
      {"penalty", &penalty, "1", 1e-6, 1e9,
       "Initial penalty weight on constraint violation, in units of half the cost."},
      {"max_penalty", &max_penalty, "1", 1e-6, 1e9,
       "Maximum penalty weight on constraint violation, in units of half the cost."},
      {"first_gap", &first_gap, "1", 1e-12, 1e3,
       "Initial barrier parameter: product of the distance to a bound and its multiplier."},
      {"give", &give, "1", 1e-14, 1.0,
       "Regularisation of equalities in a step: change of an equality for a unit change of its multiplier."},
      {"screening", &early_check, "1", 1, 10000,
       "Iterations of the early infeasibility check: after these the solve stops if violations exceed `infeasible`, "
       "after half of them if they exceed 100 times as much."},
      {"infeasible", &infeasible, "1", 0.0, 1e12,
       "Sum of constraint violations above which a solve is stopped as infeasible after `screening` iterations."},
      {"infeasible_largest", &infeasible_largest, "1", 0.0, 1e12,
       "Largest violation that the early infeasibility check lets pass."},
      {"max_iterations", &max_iterations, "1", 1, 10000, "Maximum number of iterations."}};
}

void SetUnmet(const ElasticRows& rows, const std::vector<std::pair<Eigen::Index, double>>& violations, double tolerance,
              ConstrainedSolution& solution) {
  std::map<std::string, double> by;
  double largest = 0.0;
  for (const auto& [row, violation] : violations) {
    if (violation <= tolerance) continue;
    double& worst = by[rows.NameOf(row)];
    worst = std::max(worst, violation);
    if (violation <= largest) continue;
    largest = violation;
    solution.worst_family = rows.FamilyOf(row);
  }
  solution.unmet.assign(by.begin(), by.end());
  std::stable_sort(solution.unmet.begin(), solution.unmet.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  if (!solution.unmet.empty()) solution.worst_constraint = solution.unmet.front().first;
}

Result<ConstrainedSolution> SolveElastic(const ConstrainedProblem& problem, const ElasticOptions& options,
                                         ConstrainedSolution* last) {
  CheckConstrainedProblem(problem);
  if (problem.lower.size() + problem.upper.size() > 0)
    throw InvalidArgument("SolveElastic: bounds are not supported; give them as constraints");
  RowsOfProblem rows(problem);
  return SolveElasticRows(rows, {problem.start, problem.start_multipliers}, options, last);
}

}  // namespace gaitwright
