// SPDX-License-Identifier: BSD-3-Clause
// Rows that limit the jerk of joints, which is constant between knots: the change of acceleration from the knot before
// over the time between them. They meet four control points, one more than all other rows.
#include <array>

#include "optimisation/trajectory/body_rows_internal.h"

namespace gaitwright {
namespace {

using Eigen::Index;

/// Weights of four control points, from that of the knot before on, in the change of acceleration.
std::array<double, 4> ChangeOf(const KnotBasis& before, const KnotBasis& now) {
  return {-before.acceleration[0], now.acceleration[0] - before.acceleration[1],
          now.acceleration[1] - before.acceleration[2], now.acceleration[2]};
}

}  // namespace

/// What a change of acceleration is multiplied by: 1 is what a joint may use.
double BodyRows::JerkScale(std::size_t k, int dof) const {
  return 1.0 / ((problem_.time_s[k] - problem_.time_s[k - 1]) * problem_.use.speed * model_.MotorOf(dof).jerk_limit);
}

void BodyRows::FillJerks(std::size_t k, const Eigen::Ref<const VectorX>& before, const Eigen::Ref<const VectorX>& now,
                         VectorX& rows) const {
  const Knot& knot = knots_[k];
  for (Index i = 0; i < knot.row[kKinds] - knot.row[kJerk]; ++i) {
    const int dof = jerked_[static_cast<std::size_t>(i)];
    rows[knot.row[kJerk] + i] = JerkScale(k, dof) * (now[6 + dof] - before[6 + dof]);
  }
}

void BodyRows::AddJerkGradient(std::size_t k, const VectorX& by, VectorX& gradient) const {
  const Knot& knot = knots_[k];
  if (knot.row[kKinds] == knot.row[kJerk]) return;
  const std::array<double, 4> change = ChangeOf(basis_[k - 1], basis_[k]);
  for (Index i = 0; i < knot.row[kKinds] - knot.row[kJerk]; ++i) {
    const int dof = jerked_[static_cast<std::size_t>(i)];
    const double scaled = JerkScale(k, dof) * by[knot.row[kJerk] + i];
    for (std::size_t p = 0; p < change.size(); ++p)
      gradient[static_cast<Index>(k - 1 + p) * n_ + 6 + dof] += change[p] * scaled;
  }
}

void BodyRows::AddJerkSquares(std::size_t k, const VectorX& weights) {
  const Knot& knot = knots_[k];
  if (knot.row[kKinds] == knot.row[kJerk]) return;
  const std::array<double, 4> change = ChangeOf(basis_[k - 1], basis_[k]);
  const int first = static_cast<int>(k) - 1;
  for (Index i = 0; i < knot.row[kKinds] - knot.row[kJerk]; ++i) {
    const int dof = jerked_[static_cast<std::size_t>(i)];
    const double scale = JerkScale(k, dof), weight = scale * scale * weights[knot.row[kJerk] + i];
    for (int a = 0; a < 4; ++a) {
      for (int b = 0; b <= a; ++b) {
        chain_.AddTo(first + a, first + b, 6 + dof,
                     weight * change[static_cast<std::size_t>(a)] * change[static_cast<std::size_t>(b)]);
      }
    }
  }
}

}  // namespace gaitwright
