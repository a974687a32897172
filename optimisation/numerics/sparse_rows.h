// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/SparseCholesky>
#include <vector>

#include "optimisation/numerics/constrained_problem.h"

namespace gaitwright {

/// All rows of a problem, those of its residuals first, with their Jacobian J and the factors of a matrix
///   sum over rows of w_row J_row^T J_row + damping * identity
/// whose sparsity is found once. Rows that are affine are differentiated once. Keeps a reference to the problem.
class SparseRows {
 public:
  explicit SparseRows(const ConstrainedProblem& problem);

  /// How many rows there are.
  Eigen::Index count() const { return value_.size(); }
  /// How many of them are residuals.
  Eigen::Index residuals() const { return residual_rows_; }
  /// The rows' values as Evaluate left them.
  const VectorX& value() const { return value_; }
  /// The constraint that a row belongs to; null for a residual.
  const Constraint* ConstraintOf(Eigen::Index row) const { return owner_[static_cast<std::size_t>(row)]; }

  /// Computes the rows' values. The Jacobian stays that of its last computation, initially the start.
  void Evaluate(const VectorX& x);
  /// Finds the Jacobian where Evaluate has found the values last.
  void Differentiate();
  /// J^T * by.
  VectorX Gradient(const VectorX& by) const;
  /// J * by.
  VectorX Moved(const VectorX& by) const;
  /// Factors the matrix for a weight by row; those of residuals are 1. @return false if it is not positive definite.
  bool Factor(const VectorX& weights, double damping);
  /// Solves with the factors.
  VectorX Solved(const VectorX& right) const { return cholesky_.solve(right); }

 private:
  struct Term {
    const VectorFunction* function;
    bool affine, residual;
    std::vector<int> variables;
    Eigen::Index row = 0;                  // its first
    std::vector<Eigen::Index> slots = {};  // of the lower triangle, column by column
    VectorX x = {}, value = {};
    MatrixX J = {}, weighted = {};
  };

  void Add(const VectorFunction& function, const std::vector<int>& variables, bool affine, const VectorX& start,
           const Constraint* owner);
  void FindPattern();
  Eigen::Index Slot(int row, int column) const;
  static void AddSquare(const Term& term, VectorX& values);

  std::vector<Term> terms_;
  std::vector<const Constraint*> owner_;
  Eigen::Index residual_rows_ = 0, size_ = 0;
  VectorX value_, fixed_;
  Eigen::SparseMatrix<double> matrix_;
  std::vector<Eigen::Index> diagonal_;
  Eigen::SimplicialLLT<Eigen::SparseMatrix<double>, Eigen::Lower, Eigen::AMDOrdering<int>> cholesky_;
};

}  // namespace gaitwright
