// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace gaitwright {

/// Increment of the state of SplitMix for each number: 2^64 divided by the golden ratio, odd.
inline constexpr std::uint64_t kSplitMixStep = 0x9e3779b97f4a7c15ULL;

/// Mixes the bits of a number, so that the results of neighbours are unrelated: the output function of SplitMix64.
constexpr std::uint64_t MixBits(std::uint64_t z) {
  z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27U)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31U);
}

/// A stream of random numbers that is the same on every machine and with every standard library. Each number depends
/// only on the seed and its position in the stream. Steele et al., SplitMix64, OOPSLA 2014,
/// doi:10.1145/2660193.2660195.
class SplitMix {
 public:
  explicit SplitMix(std::uint64_t seed) : state_(seed) {}

  /// 64 random bits.
  std::uint64_t Bits() { return MixBits(state_ += kSplitMixStep); }
  /// Uniform in [0, 1), on a grid of 2^-53.
  double Uniform() { return static_cast<double>(Bits() >> 11U) * 0x1.0p-53; }
  /// Normal with mean 0 and variance 1. Box and Muller, Ann. Math. Statist. 29(2), 1958.
  double Normal();

 private:
  std::uint64_t state_;
};

}  // namespace gaitwright
