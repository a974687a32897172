// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace gaitwright {

/// A stream of random numbers that is equal on every machine and with every standard library. Each number depends only
/// on the seed and its index. Steele et al., SplitMix64, OOPSLA 2014, doi:10.1145/2660193.2660195.
class SplitMix {
 public:
  explicit SplitMix(std::uint64_t seed) : state_(seed) {}

  /// 64 random bits.
  std::uint64_t Bits();
  /// Uniform in [0, 1), on a grid of 2^-53.
  double Uniform();
  /// Normal with mean 0 and variance 1. Box and Muller, Ann. Math. Statist. 29(2), 1958.
  double Normal();

 private:
  std::uint64_t state_;
};

}  // namespace gaitwright
