// SPDX-License-Identifier: BSD-3-Clause
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

Result<ConstrainedSolution> SolveElastic(const ConstrainedProblem& problem, const ElasticOptions& options,
                                         ConstrainedSolution* last) {
  CheckConstrainedProblem(problem);
  if (problem.lower.size() + problem.upper.size() > 0)
    throw InvalidArgument("SolveElastic: bounds are not supported; give them as constraints");
  RowsOfProblem rows(problem);
  return SolveElasticRows(rows, problem.start, options, last);
}

}  // namespace gaitwright
