// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/spatial/pose.h"

namespace gaitwright {

/// Solves square systems A x = b of one size repeatedly, by Gaussian elimination with partial pivoting, without
/// allocating memory. The solver of Eigen allocates memory for its blocked algorithm, which is faster only for much
/// larger sizes. Golub, Van Loan, Matrix Computations, 2013, algorithm 3.4.1.
class SquareSolver {
 public:
  explicit SquareSolver(Eigen::Index size = 0);

  /// The matrix A, size n x n. Set it before Factor, which overwrites it.
  MatrixX& matrix() { return matrix_; }

  /// Factorises matrix(). A singular matrix gives solutions that are not finite.
  void Factor();

  /// Solves A x = b, both of size n; x is resized. Call Factor first. b and x must be different vectors.
  void Solve(const VectorX& b, VectorX& x) const;

 private:
  MatrixX matrix_;                  // after Factor: L below the diagonal, U on and above
  std::vector<Eigen::Index> rows_;  // row of A at each position after pivoting
};

}  // namespace gaitwright
