// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/spatial/pose.h"

namespace gaitwright {

/// Control points of the detour of a SwingCurve (`detour_W`) that is nearest to given offsets from its straight move,
/// in the sense of least squares; of several, those with the least norm.
/// @param shares  fractions of the swing at which the offsets are given, from 0 to 1.
/// @param off_W   offset of the path from the straight move, by fraction [m].
/// @param points  number of free control points, from 1 to the number of fractions.
/// @throws InvalidArgument for other numbers.
std::vector<Vector3> FitDetour(const std::vector<double>& shares, const std::vector<Vector3>& off_W, int points);

}  // namespace gaitwright
