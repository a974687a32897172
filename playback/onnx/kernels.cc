// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Core>

#include "playback/onnx/kernels_internal.h"

namespace gaitwright::onnx {
namespace {

using Vector = Eigen::Map<Eigen::VectorXf>;
using Columns = Eigen::Map<const Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor>>;
using Rows = Eigen::Map<const Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>;

}  // namespace

void Elementwise::Run(float* memory) const {
  const float* in = memory + places_.in;
  float* out = memory + places_.out;
  for (std::int64_t i = 0; i < places_.count; ++i) out[i] = function_(in[i], a_, b_);
}

void Pairwise::Run(float* memory) const {
  float* out = memory + out_;
  for (std::size_t i = 0; i < x_.size(); ++i) out[i] = function_(memory[x_[i]], memory[y_[i]]);
}

void Gathered::Run(float* memory) const {
  float* out = memory + out_;
  for (std::size_t i = 0; i < from_.size(); ++i) out[i] = memory[from_[i]];
}

void Product::Run(float* memory) const {
  // One matrix-vector product for each row: networks are evaluated for one observation, and Eigen's product of two
  // matrices would allocate.
  const auto k = static_cast<Eigen::Index>(p_.k), n = static_cast<Eigen::Index>(p_.n);
  for (std::int64_t row = 0; row < p_.m; ++row) {
    Vector out(memory + p_.out + row * p_.n, n);
    out.setZero();
    if (p_.a_transposed && p_.m > 1) {  // a column of the stored matrix
      for (std::int64_t i = 0; i < p_.k; ++i) {
        const float a = p_.alpha * memory[p_.a + i * p_.m + row];
        for (std::int64_t j = 0; j < p_.n; ++j)
          out[static_cast<Eigen::Index>(j)] += a * memory[p_.b + (p_.b_transposed ? j * p_.k + i : i * p_.n + j)];
      }
      continue;
    }
    const Eigen::Map<const Eigen::VectorXf> a(memory + p_.a + row * p_.k, k);
    if (p_.b_transposed) {
      out.noalias() += p_.alpha * (Rows(memory + p_.b, n, k) * a);
    } else {
      out.noalias() += p_.alpha * (Columns(memory + p_.b, n, k) * a);
    }
  }
}

void Added::Run(float* memory) const {
  float* out = memory + out_;
  for (std::size_t i = 0; i < c_.size(); ++i) out[i] += beta_ * memory[c_[i]];
}

}  // namespace gaitwright::onnx
