// SPDX-License-Identifier: BSD-3-Clause
#include "planning/plan/value_noise.h"

#include <cmath>

#include "kinematics/base/random.h"
#include "kinematics/trajectory/swing_curve.h"

namespace gaitwright {

double UniformAt(std::int64_t ix, std::int64_t iy, std::uint64_t seed) {
  std::uint64_t z = seed * kSplitMixStep + static_cast<std::uint64_t>(ix) * 0xD1B54A32D192ED03ULL +
                    static_cast<std::uint64_t>(iy) * 0x8CB92BA72F3D8DD7ULL;
  for (int i = 0; i < 2; ++i) z = MixBits(z + kSplitMixStep);
  return static_cast<double>(z >> 11U) * 0x1.0p-52 - 1.0;
}

double ValueNoise(const Vector2& p, double wavelength_m, std::uint64_t seed) {
  const Vector2 cell = p / (0.5 * wavelength_m);
  const double fx = std::floor(cell.x()), fy = std::floor(cell.y());
  const double u = SmoothStep(cell.x() - fx).value, v = SmoothStep(cell.y() - fy).value;
  const auto ix = static_cast<std::int64_t>(fx), iy = static_cast<std::int64_t>(fy);
  const auto value = [&](std::int64_t dx, std::int64_t dy) { return UniformAt(ix + dx, iy + dy, seed); };
  return (1.0 - v) * ((1.0 - u) * value(0, 0) + u * value(1, 0)) + v * ((1.0 - u) * value(0, 1) + u * value(1, 1));
}

}  // namespace gaitwright
