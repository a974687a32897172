// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Eigenvalues>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <utility>

#include "kinematics/base/result.h"
#include "playback/trials/floquet_multipliers_internal.h"

namespace gaitwright {
namespace {

constexpr double kLeast = 0.1;       // of the first deviation
constexpr double kLeastSize = 0.05;  // of the largest singular value

/// Deviations by column, each beside its successor.
struct MapSamples {
  MatrixX before, after;
};

MapSamples SamplesOf(const std::vector<CycleDeviations>& sequences, std::size_t without) {
  std::vector<std::pair<const VectorX*, const VectorX*>> used;
  std::vector<double> scales;
  for (std::size_t i = 0; i < sequences.size(); ++i) {
    for (std::size_t k = 0; i != without && k + 1 < sequences[i].size(); ++k) {
      const double first = sequences[i].front().norm();
      if (first == 0.0 || sequences[i][k].norm() < kLeast * first) break;
      used.emplace_back(&sequences[i][k], &sequences[i][k + 1]);
      scales.push_back(1.0 / first);
    }
  }
  const Eigen::Index size = used.empty() ? 0 : used.front().first->size();
  MapSamples samples{MatrixX(size, static_cast<Eigen::Index>(used.size())), {}};
  samples.after = samples.before;
  for (std::size_t i = 0; i < used.size(); ++i) {
    const auto column = static_cast<Eigen::Index>(i);
    if (used[i].first->size() != size || used[i].second->size() != size)
      throw InvalidArgument("deviations of different cycles have different sizes");
    samples.before.col(column) = scales[i] * *used[i].first;
    samples.after.col(column) = scales[i] * *used[i].second;
  }
  return samples;
}

/// The map within the subspace of the deviations.
struct ReducedMap {
  MatrixX basis;  ///< orthonormal columns
  MatrixX A;      ///< between coefficients of the basis
};

ReducedMap FitMap(const MapSamples& samples) {
  if (samples.before.size() == 0) return {};
  const Eigen::BDCSVD<MatrixX> svd(samples.before, Eigen::ComputeThinU | Eigen::ComputeThinV);
  const VectorX& sizes = svd.singularValues();
  Eigen::Index rank = 0;
  while (rank < sizes.size() && sizes[rank] > kLeastSize * sizes[0]) ++rank;
  rank = std::min(rank, std::max<Eigen::Index>(samples.before.cols() / 2, 1));  // more equations than unknowns
  const MatrixX U = svd.matrixU().leftCols(rank), V = svd.matrixV().leftCols(rank);
  return {U, U.transpose() * samples.after * V * sizes.head(rank).cwiseInverse().asDiagonal()};
}

}  // namespace

FloquetMultipliers EstimateMultipliers(const std::vector<CycleDeviations>& sequences) {
  FloquetMultipliers result;
  const ReducedMap all = FitMap(SamplesOf(sequences, sequences.size()));
  if (all.A.size() == 0) return result;
  const Eigen::VectorXcd values = all.A.eigenvalues();
  result.values.assign(values.begin(), values.end());
  std::sort(result.values.begin(), result.values.end(), [](const auto& a, const auto& b) {
    return std::abs(a) != std::abs(b) ? std::abs(a) > std::abs(b) : a.imag() > b.imag();
  });
  double off = 0.0, whole = 0.0;
  for (std::size_t i = 0; i < sequences.size(); ++i) {
    const ReducedMap others = FitMap(SamplesOf(sequences, i));
    const MapSamples left_out = SamplesOf({sequences[i]}, 1);
    if (left_out.before.size() == 0) continue;
    whole += left_out.after.squaredNorm();
    const bool none = others.A.size() == 0;
    off +=
        none
            ? left_out.after.squaredNorm()
            : (left_out.after - others.basis * (others.A * (others.basis.transpose() * left_out.before))).squaredNorm();
  }
  result.unexplained = whole > 0.0 ? std::sqrt(off / whole) : 0.0;
  return result;
}

}  // namespace gaitwright
