// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/spatial/pose.h"

namespace gaitwright {

/// What durations of phases may be: each by itself, and all together [s].
struct DurationBounds {
  VectorX lower, upper;
  double least_total_s = 0.0, most_total_s = 0.0;
};

/// The durations within bounds that are nearest to wanted ones; where the least total is the most, their sum is that to
/// the last digits. Only for bounds that hold some.
VectorX NearestDurations(const VectorX& wanted, const DurationBounds& bounds);

/// Durations within bounds, near to the least of slope . d + d . curvature d / 2 for a step d from `at` whose parts are
/// no greater than `most`, by accelerated projected gradients (Beck and Teboulle, SIAM J. Imaging Sciences 2, 2009,
/// algorithm 4.1, restarted where the model rises).
/// @param curvature  symmetric, not negative.
VectorX BestDurations(const VectorX& at, const VectorX& slope, const MatrixX& curvature, const VectorX& most,
                      const DurationBounds& bounds);

}  // namespace gaitwright
