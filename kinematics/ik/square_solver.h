// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/spatial/pose.h"

namespace gaitwright {

/// Square systems A x = b of one size, solved again and again by Gaussian elimination with partial pivoting, without
/// allocating: Eigen's own solver allocates for its blocked algorithm, which is faster only for much larger sizes.
/// Golub, Van Loan, Matrix Computations, 2013, algorithm 3.4.1.
class SquareSolver {
 public:
  explicit SquareSolver(Eigen::Index size = 0);

  /// The matrix to be filled before Factor, size n x n; Factor destroys it.
  MatrixX& matrix() { return matrix_; }

  /// Factorises matrix(). A singular matrix gives solutions that are not finite.
  void Factor();

  /// x of A x = b, both of size n; x is resized. Factor first. b and x must be different vectors.
  void Solve(const VectorX& b, VectorX& x) const;

 private:
  MatrixX matrix_;                  // after Factor: L below the diagonal, U on and above
  std::vector<Eigen::Index> rows_;  // row of A that came to each place
};

}  // namespace gaitwright
