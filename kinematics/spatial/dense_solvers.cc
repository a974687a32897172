// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/spatial/dense_solvers.h"

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <Eigen/SVD>

namespace gaitwright {

VectorX SolveSymmetric(const MatrixX& A, const VectorX& b) { return A.ldlt().solve(b); }

MatrixX SolveLeastSquares(const MatrixX& A, const MatrixX& B) { return A.colPivHouseholderQr().solve(B); }

MatrixX SolveLeastNorm(const MatrixX& A, const MatrixX& B) { return A.completeOrthogonalDecomposition().solve(B); }

LeftSingularVectors LeftSingularVectorsOf(const MatrixX& A) {
  const Eigen::JacobiSVD<MatrixX> svd(A, Eigen::ComputeFullU);
  return {svd.singularValues(), svd.matrixU()};
}

}  // namespace gaitwright
