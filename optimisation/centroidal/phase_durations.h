// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/spatial/pose.h"

namespace gaitwright {

/// Bounds on the durations of phases: of each phase, and of their sum [s].
struct DurationBounds {
  VectorX lower, upper;
  double least_total_s = 0.0, most_total_s = 0.0;
};

/// The durations within bounds that are closest to the wanted ones; if the least and largest totals are equal, their
/// sum equals it to rounding. @pre the bounds are feasible.
VectorX NearestDurations(const VectorX& wanted, const DurationBounds& bounds);

/// Durations within bounds that approximately minimise slope . d + d . curvature d / 2 for a step d from `at` with
/// components up to `most`, by accelerated projected gradients (Beck and Teboulle, SIAM J. Imaging Sciences 2, 2009,
/// algorithm 4.1, restarted if the model rises).
/// @param curvature  symmetric positive semidefinite.
VectorX BestDurations(const VectorX& at, const VectorX& slope, const MatrixX& curvature, const VectorX& most,
                      const DurationBounds& bounds);

}  // namespace gaitwright
