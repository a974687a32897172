// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/ik/square_solver.h"

#include <numeric>
#include <utility>

namespace gaitwright {

SquareSolver::SquareSolver(Eigen::Index size) : matrix_(size, size), rows_(static_cast<std::size_t>(size)) {}

void SquareSolver::Factor() {
  const Eigen::Index n = matrix_.rows();
  std::iota(rows_.begin(), rows_.end(), Eigen::Index{0});
  for (Eigen::Index k = 0; k < n; ++k) {
    Eigen::Index pivot = 0;
    matrix_.col(k).tail(n - k).cwiseAbs().maxCoeff(&pivot);
    pivot += k;
    if (pivot != k) {
      matrix_.row(k).swap(matrix_.row(pivot));
      std::swap(rows_[static_cast<std::size_t>(k)], rows_[static_cast<std::size_t>(pivot)]);
    }
    const Eigen::Index below = n - k - 1;
    matrix_.col(k).tail(below) /= matrix_(k, k);
    for (Eigen::Index c = k + 1; c < n; ++c) {
      const double factor = matrix_(k, c);
      if (factor != 0.0) matrix_.col(c).tail(below) -= factor * matrix_.col(k).tail(below);
    }
  }
}

void SquareSolver::Solve(const VectorX& b, VectorX& x) const {
  const Eigen::Index n = matrix_.rows();
  x.resize(n);
  for (Eigen::Index i = 0; i < n; ++i) x[i] = b[rows_[static_cast<std::size_t>(i)]];
  for (Eigen::Index k = 0; k < n; ++k) x.tail(n - k - 1) -= x[k] * matrix_.col(k).tail(n - k - 1);
  for (Eigen::Index k = n; k-- > 0;) {
    x[k] /= matrix_(k, k);
    x.head(k) -= x[k] * matrix_.col(k).head(k);
  }
}

}  // namespace gaitwright
