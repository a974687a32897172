// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/numerics/split_mix.h"

#include <cmath>
#include <numbers>

namespace gaitwright {

std::uint64_t SplitMix::Bits() {
  state_ += 0x9e3779b97f4a7c15ULL;
  std::uint64_t z = state_;
  z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27U)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31U);
}

double SplitMix::Uniform() { return static_cast<double>(Bits() >> 11U) * 0x1.0p-53; }

double SplitMix::Normal() {
  const double radius = std::sqrt(-2.0 * std::log(1.0 - Uniform()));
  return radius * std::cos(2.0 * std::numbers::pi * Uniform());
}

}  // namespace gaitwright
