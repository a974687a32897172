// SPDX-License-Identifier: BSD-3-Clause
// Decompositions of small dense matrices whose size is known only at run time. As functions they are compiled once;
// otherwise each needs a second or two of compile time in every file that instantiates it. Use Eigen for inner loops
// with known sizes.
#pragma once

#include "kinematics/spatial/pose.h"

namespace gaitwright {

/// Solves A x = b for a symmetric A, n x n, by LDL^T with pivoting; only the lower triangle of A is read.
VectorX SolveSymmetric(const MatrixX& A, const VectorX& b);

/// X, n x k, that minimises |A X - B| for A, m x n, and B, m x k: QR with column pivoting.
MatrixX SolveLeastSquares(const MatrixX& A, const MatrixX& B);

/// The solution X of SolveLeastSquares with the least norm: complete orthogonal decomposition.
MatrixX SolveLeastNorm(const MatrixX& A, const MatrixX& B);

/// Singular values, in decreasing order, and left singular vectors U, m x m, of a matrix A, m x n.
struct LeftSingularVectors {
  VectorX values;
  MatrixX U;
};

/// Singular values and left singular vectors of A, by one-sided Jacobi rotations.
LeftSingularVectors LeftSingularVectorsOf(const MatrixX& A);

}  // namespace gaitwright
