// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/SparseCholesky>
#include <vector>

#include "optimisation/numerics/constrained_problem.h"

namespace gaitwright {

/// All rows of a problem, residuals first, with their Jacobian J and the factors of the matrix
///   sum over rows of w_row J_row^T J_row + damping * identity.
/// Its sparsity is determined once. Affine rows are differentiated once. Keeps a reference to the problem.
class SparseRows {
 public:
  explicit SparseRows(const ConstrainedProblem& problem);

  /// Number of rows.
  Eigen::Index count() const { return value_.size(); }
  /// Number of rows that are residuals.
  Eigen::Index residuals() const { return residual_rows_; }
  /// Values of the rows at the last Evaluate.
  const VectorX& value() const { return value_; }
  /// The constraint of a row; null for a residual.
  const Constraint* ConstraintOf(Eigen::Index row) const { return owner_[static_cast<std::size_t>(row)]; }

  /// Computes the values of the rows. The Jacobian is not changed; initially it is that at the start.
  void Evaluate(const VectorX& x);
  /// Computes the Jacobian at the point of the last Evaluate.
  void Differentiate();
  /// J^T * by.
  VectorX Gradient(const VectorX& by) const;
  /// J * by.
  VectorX Moved(const VectorX& by) const;
  /// Factors the matrix for one weight per row; the weights of residuals are 1. @return false if it is not positive
  /// definite.
  bool Factor(const VectorX& weights, double damping);
  /// Solves with the present factors.
  VectorX Solved(const VectorX& right) const { return cholesky_.solve(right); }

 private:
  struct Term {
    const VectorFunction* function;
    bool affine, residual;
    std::vector<int> variables;
    Eigen::Index row = 0;                  // index of its first row
    std::vector<Eigen::Index> slots = {};  // entries of the lower triangle, column by column
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
