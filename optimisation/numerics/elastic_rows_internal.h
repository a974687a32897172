// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "optimisation/numerics/elastic_interior.h"

namespace gaitwright {

/// lower <= value <= upper of a row; equal bounds make an equality, an infinite bound a one-sided constraint.
struct RowBounds {
  double lower, upper;
};

/// The rows of a problem as SolveElasticRows sees them, residuals first, with their Jacobian J and the factors of
///   sum over rows of w_row J_row^T J_row + damping * identity.
/// A problem with structure implements it with a factorisation that exploits the structure.
class ElasticRows {
 public:
  virtual ~ElasticRows() = default;

  virtual Eigen::Index count() const = 0;
  /// How many of the rows are residuals.
  virtual Eigen::Index residuals() const = 0;
  /// The rows' values at the last point that was evaluated.
  virtual const VectorX& value() const = 0;
  /// Of a row that is no residual.
  virtual RowBounds BoundsOf(Eigen::Index row) const = 0;
  /// Of a row that is no residual, for people. Rows of one name count as one constraint.
  virtual std::string NameOf(Eigen::Index row) const = 0;
  /// Constraint::family of such a row.
  virtual int FamilyOf(Eigen::Index /*row*/) const { return 0; }
  /// Sum of all violations that is too small to say how much they weigh against the cost.
  virtual double unnoticed() const { return 1e-9; }

  virtual void Evaluate(const VectorX& x) = 0;
  /// Finds the Jacobian where Evaluate was last; at first that of the start must be found already.
  virtual void Differentiate() = 0;
  /// J^T * by.
  virtual VectorX Gradient(const VectorX& by) const = 0;
  /// J * by.
  virtual VectorX Moved(const VectorX& by) const = 0;
  /// Factors the matrix for a weight by row; those of residuals are 1. @return false if it is not positive definite.
  virtual bool Factor(const VectorX& weights, double damping) = 0;
  /// Solves with the factors.
  virtual VectorX Solved(const VectorX& right) const = 0;
};

/// Where a solve starts: a point and, if a similar problem was solved before, its multipliers. A warm start, with both,
/// begins close to complementarity and takes a few steps.
struct ElasticStart {
  VectorX x;
  VectorX multipliers = {};  ///< as in ConstrainedSolution; empty, or of another number of rows: not known
};

/// Sets the unmet constraints of a solution, and the worst of them. @param violations  by row, those of others may be
/// missing.
void SetUnmet(const ElasticRows& rows, const std::vector<std::pair<Eigen::Index, double>>& violations, double tolerance,
              ConstrainedSolution& solution);

/// SolveElastic of such rows.
Result<ConstrainedSolution> SolveElasticRows(ElasticRows& rows, const ElasticStart& start,
                                             const ElasticOptions& options, ConstrainedSolution* last = nullptr);

}  // namespace gaitwright
