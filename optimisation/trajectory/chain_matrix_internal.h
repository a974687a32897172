// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/spatial/pose.h"

namespace gaitwright {

/// A symmetric positive definite matrix of square blocks in which block i meets blocks i - reach to i + reach alone,
/// and its Cholesky factors, which have the same pattern: their cost is linear in the number of blocks.
class ChainMatrix {
 public:
  ChainMatrix(Eigen::Index block_size, int blocks, int reach = 2);

  /// The matrix of `damping` on the diagonal.
  void SetDiagonal(double damping);
  /// Where a lower triangle of three blocks squared is to be added, its first block on block `first` of the diagonal.
  void Add(int first, const Eigen::Ref<const MatrixX>& lower);
  /// Adds to one element of the lower triangle. @param row, column  blocks, no farther apart than the reach.
  /// @param i  of the diagonal of that block.
  void AddTo(int row, int column, Eigen::Index i, double value) {
    columns_((row - column) * size_ + i, column * size_ + i) += value;
  }
  /// @return false if the matrix is not positive definite.
  bool Factor();
  /// Solves in place with the factors; for each column.
  void Solve(Eigen::Ref<VectorX> right) const { SolveInPlace(right); }
  void SolveAll(Eigen::Ref<MatrixX> right) const { SolveInPlace(right); }

 private:
  template <class Right>
  void SolveInPlace(Right& right) const;
  /// Block column: what is at and below the diagonal.
  auto Column(int block) { return columns_.middleCols(block * size_, size_); }
  auto Column(int block) const { return columns_.middleCols(block * size_, size_); }

  Eigen::Index size_;
  int blocks_, reach_;
  MatrixX columns_;
};

}  // namespace gaitwright
