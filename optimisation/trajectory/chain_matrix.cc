// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Cholesky>
#include <algorithm>

#include "optimisation/trajectory/chain_matrix_internal.h"

namespace gaitwright {

ChainMatrix::ChainMatrix(Eigen::Index block_size, int blocks, int reach)
    : size_(block_size), blocks_(blocks), reach_(reach), columns_((1 + reach) * block_size, block_size * blocks) {}

void ChainMatrix::SetDiagonal(double damping) {
  columns_.setZero();
  for (int k = 0; k < blocks_; ++k) Column(k).topRows(size_).diagonal().setConstant(damping);
}

void ChainMatrix::Add(int first, const Eigen::Ref<const MatrixX>& lower) {
  for (int j = 0; j < 3; ++j) {
    const Eigen::Index rows = (3 - j) * size_;
    Column(first + j).topRows(rows) += lower.block(j * size_, j * size_, rows, size_);
  }
}

bool ChainMatrix::Factor() {
  for (int k = 0; k < blocks_; ++k) {
    auto column = Column(k);
    Eigen::Ref<MatrixX> diagonal = column.topRows(size_);
    if (const Eigen::LLT<Eigen::Ref<MatrixX>> factors(diagonal); factors.info() != Eigen::Success) return false;
    const int below = std::min(reach_, blocks_ - 1 - k);
    auto rest = column.middleRows(size_, below * size_);
    diagonal.triangularView<Eigen::Lower>().transpose().solveInPlace<Eigen::OnTheRight>(rest);
    for (int j = 0; j < below; ++j) {
      const auto by = rest.middleRows(j * size_, size_);
      auto next = Column(k + 1 + j);
      next.topRows((below - j) * size_).noalias() -= rest.bottomRows((below - j) * size_) * by.transpose();
    }
  }
  return true;
}

template <class Right>
void ChainMatrix::SolveInPlace(Right& right) const {
  for (int k = 0; k < blocks_; ++k) {
    auto own = right.middleRows(k * size_, size_);
    const Eigen::Ref<const MatrixX> diagonal = Column(k).topRows(size_);
    diagonal.triangularView<Eigen::Lower>().solveInPlace(own);
    const Eigen::Index below = std::min(reach_, blocks_ - 1 - k) * size_;
    right.middleRows((k + 1) * size_, below).noalias() -= Column(k).middleRows(size_, below) * own;
  }
  for (int k = blocks_ - 1; k >= 0; --k) {
    auto own = right.middleRows(k * size_, size_);
    const Eigen::Index below = std::min(reach_, blocks_ - 1 - k) * size_;
    own.noalias() -= Column(k).middleRows(size_, below).transpose() * right.middleRows((k + 1) * size_, below);
    const Eigen::Ref<const MatrixX> diagonal = Column(k).topRows(size_);
    diagonal.triangularView<Eigen::Lower>().transpose().solveInPlace(own);
  }
}

template void ChainMatrix::SolveInPlace(Eigen::Ref<VectorX>& right) const;
template void ChainMatrix::SolveInPlace(Eigen::Ref<MatrixX>& right) const;

}  // namespace gaitwright
