// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/numerics/smooth_within.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>

#include "kinematics/base/result.h"
#include "kinematics/spatial/pose.h"

namespace gaitwright {
namespace {

using SparseMatrix = Eigen::SparseMatrix<double>;

/// Second differences; the numbers are constant beyond both ends.
SparseMatrix SecondDifferences(Eigen::Index count) {
  std::vector<Eigen::Triplet<double>> entries;
  for (Eigen::Index k = 0; k < count; ++k) {
    entries.emplace_back(k, k, -2.0);
    entries.emplace_back(k, std::max<Eigen::Index>(k - 1, 0), 1.0);
    entries.emplace_back(k, std::min(k + 1, count - 1), 1.0);
  }
  SparseMatrix differences(count, count);
  differences.setFromTriplets(entries.begin(), entries.end());
  return differences;
}

}  // namespace

std::vector<double> SmoothWithin(const std::vector<double>& wanted, const std::vector<Bounds>& bounds, double stiff,
                                 double firm) {
  constexpr int kMostSets = 100;
  if (wanted.size() < 3 || bounds.size() != wanted.size())
    throw InvalidArgument("SmoothWithin: three or more numbers are needed, with one pair of bounds for each");
  const auto count = static_cast<Eigen::Index>(wanted.size());
  VectorX low(count), high(count);
  for (Eigen::Index k = 0; k < count; ++k) {
    const Bounds& b = bounds[static_cast<std::size_t>(k)];
    low[k] = b.low <= b.high ? b.low : 0.5 * (b.low + b.high);
    high[k] = b.low <= b.high ? b.high : low[k];
  }
  const VectorX want = Eigen::Map<const VectorX>(wanted.data(), count);
  const SparseMatrix D = SecondDifferences(count);
  SparseMatrix A = std::pow(stiff, 4.0) * SparseMatrix(D.transpose() * D);
  for (Eigen::Index k = 0; k < count; ++k) A.coeffRef(k, k) += 1.0;
  std::vector<int> held(wanted.size(), 0), before;  // -1 at the lower bound, 1 at the upper one
  VectorX z = want;
  for (int set = 0; set < kMostSets && held != before; ++set) {
    SparseMatrix B = A;
    VectorX right = want;
    for (Eigen::Index k = 0; k < count; ++k) {
      const int side = held[static_cast<std::size_t>(k)];
      if (side == 0) continue;
      B.coeffRef(k, k) += firm;
      right[k] += firm * (side < 0 ? low[k] : high[k]);
    }
    z = Eigen::SimplicialLDLT<SparseMatrix>(B).solve(right);
    before = held;
    for (Eigen::Index k = 0; k < count; ++k)
      held[static_cast<std::size_t>(k)] = z[k] < low[k] ? -1 : z[k] > high[k] ? 1 : 0;
  }
  return {z.data(), z.data() + count};
}

}  // namespace gaitwright
