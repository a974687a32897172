// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

#include "kinematics/spatial/pose.h"

namespace gaitwright {

/// Radical inverse of `index` in `base`: its digits mirrored at the point. For example, 6 = 110 in base 2 becomes 0.011
/// = 3/8. In [0, 1).  @throws InvalidArgument unless base is 2 or more.
double RadicalInverse(std::uint64_t index, std::uint64_t base);

/// Largest number of coordinates of HaltonPoint; for larger bases the points lie on lines.
inline constexpr int kMostHaltonCoordinates = 20;

/// Point number `index`, from 0, of a sequence that fills the unit cube evenly: coordinate k is the radical inverse of
/// index + 1 in the k-th prime. Seed 0 gives the plain sequence. Another seed adds a different shift to each
/// coordinate, modulo 1 (Cranley and Patterson, SIAM J. Numer. Anal. 13(6), 1976); the points stay evenly distributed.
/// Halton, Numerische Mathematik 2, 1960, doi:10.1007/BF01386213.
/// @return numbers in [0, 1).  @throws InvalidArgument unless there are 1 to kMostHaltonCoordinates coordinates.
VectorX HaltonPoint(std::uint64_t index, int coordinates, std::uint64_t seed = 0);

}  // namespace gaitwright
