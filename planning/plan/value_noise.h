// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "kinematics/spatial/pose.h"

namespace gaitwright {

/// Random number in [-1, 1], uniform; a function of the grid cell and the seed only. Steele et al., SplitMix64, OOPSLA
/// 2014, doi:10.1145/2660193.2660195.
double UniformAt(std::int64_t ix, std::int64_t iy, std::uint64_t seed);

/// Smooth noise in [-1, 1]: UniformAt on a grid of half a wavelength, blended by 6u^5 - 15u^4 + 10u^3.
/// Perlin, ACM SIGGRAPH 2002, doi:10.1145/566654.566636, for the blend.
/// @param wavelength_m  > 0.
double ValueNoise(const Vector2& p, double wavelength_m, std::uint64_t seed);

}  // namespace gaitwright
