// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "kinematics/base/options.h"
#include "kinematics/base/random.h"
#include "kinematics/spatial/pose.h"

namespace gaitwright {

/// Tuning
///   stops at a poor optimum of a noisy or wavy function    raise population
///   strays far before it improves                          lower spread
struct CmaEsOptions {
  int population = 0;
  double spread = 0.2;

  OptionFields Fields() {
    return {{"population", &population, "1", 0.0, 1000.0,
             "Number of points in a generation; 0 uses 4 + 3 ln n for n unknowns."},
            {"spread", &spread, "1", 1e-6, 1.0,
             "Standard deviation of the first generation, as a share of the range of each unknown."}};
  }
};

/// Derivative-free minimisation of a function of n unknowns, each in [0, 1], by the covariance matrix adaptation
/// evolution strategy. Each generation is drawn from a normal distribution about a mean. The better half of it moves
/// the mean. The path of the mean stretches the distribution along valleys and sets its size.
///
///     CmaEs search(start, seed);
///     while (...) {
///       const std::vector<VectorX> points = search.Ask();
///       search.Tell(values of the points);
///     }
///
/// Only the order of values matters. A point without a value ranks last; a generation without any value keeps the mean
/// and halves the spread. Points beyond a bound are mirrored at it. Deterministic for a seed. Hansen, The CMA evolution
/// strategy: a tutorial, arXiv:1604.00772, table 1 with positive weights only.
class CmaEs {
 public:
  /// @param start  first mean. @throws InvalidArgument unless it has a coordinate, all are in [0, 1] and the options
  /// are in their ranges.
  CmaEs(const VectorX& start, std::uint64_t seed, const CmaEsOptions& options = {});

  int population() const { return population_; }
  /// Standard deviation of the distribution, without its shape.
  double spread() const { return spread_; }
  /// The mean, within the bounds.
  VectorX mean() const;

  /// The next generation, within the bounds.
  std::vector<VectorX> Ask();
  /// The values of the last generation, in its order; lower is better. @throws InvalidArgument unless there is one
  /// finite value for each requested point.
  void Tell(const std::vector<std::optional<double>>& values);

 private:
  void SetWeights();
  std::vector<std::size_t> Ranked(const std::vector<std::optional<double>>& values) const;
  void Move(const std::vector<std::size_t>& ranked);
  void Decompose();

  int population_;
  double spread_;
  SplitMix random_;
  VectorX mean_, path_, spread_path_;
  MatrixX covariance_, axes_;  ///< axes: square root of the covariance, B D
  MatrixX inverse_axes_;       ///< B D^-1 B^T
  MatrixX drawn_;              ///< the last generation: (points - mean) / spread, one column per point
  VectorX weights_;
  double mu_effective_ = 0.0, c_path_ = 0.0, c_spread_ = 0.0, c_one_ = 0.0, c_mu_ = 0.0, damping_ = 0.0;
  double expected_norm_ = 0.0;
  int generation_ = 0;
};

}  // namespace gaitwright
