// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/numerics/halton.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "kinematics/base/random.h"
#include "kinematics/base/result.h"

namespace gaitwright {
namespace {

constexpr std::array<std::uint64_t, kMostHaltonCoordinates> kPrimes = {2,  3,  5,  7,  11, 13, 17, 19, 23, 29,
                                                                       31, 37, 41, 43, 47, 53, 59, 61, 67, 71};

}  // namespace

double RadicalInverse(std::uint64_t index, std::uint64_t base) {
  if (base < 2) throw InvalidArgument(fmt::format("RadicalInverse: base is {}; 2 or more is accepted", base));
  double inverse = 0.0, digit = 1.0;
  for (; index > 0; index /= base) {
    digit /= static_cast<double>(base);
    inverse += digit * static_cast<double>(index % base);
  }
  return inverse;
}

VectorX HaltonPoint(std::uint64_t index, int coordinates, std::uint64_t seed) {
  if (coordinates < 1 || coordinates > kMostHaltonCoordinates) {
    throw InvalidArgument(fmt::format("HaltonPoint: {} coordinates are asked for; 1 to {} are accepted", coordinates,
                                      kMostHaltonCoordinates));
  }
  SplitMix shifts(seed);
  VectorX point(coordinates);
  for (int k = 0; k < coordinates; ++k) {
    const double shift = seed == 0 ? 0.0 : shifts.Uniform();
    const double sum = RadicalInverse(index + 1, kPrimes[static_cast<std::size_t>(k)]) + shift;
    point[k] = sum - std::floor(sum);
  }
  return point;
}

}  // namespace gaitwright
