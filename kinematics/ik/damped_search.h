// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/ik/leg_chain.h"

namespace gaitwright {

/// Result of a damped least-squares search.
struct DampedSearch {
  VectorX coordinates;
  bool converged = false;
  double distance_m = 0.0, angle_rad = 0.0;  ///< remaining error of the foot, controlled rows only
  int iterations = 0;
};

/// Moves the foot of a leg to a pose by damped least squares, within the limits, from a start within the limits:
///   step = J^T (J J^T + lambda 1)^-1 e,  positions scaled by the leg's length.
/// Lambda decreases with the square of the error, so the last steps are Newton steps (to 1e-11). It increases if a step
/// does not reduce the error. A coordinate at its limit is removed while the error pushes it outward. The loop
/// allocates no memory.
///
/// Levenberg-Marquardt as in Sugihara, IEEE T-RO 27(5), 2011, doi:10.1109/TRO.2011.2148230.
DampedSearch DescendToPose(const LegChain& chain, const Pose& X_BF, const VectorX& lower, const VectorX& upper,
                           const VectorX& start);

/// Searches from a guess, then from the standing posture, then from seeded random positions within the limits (a full
/// turn for joints without limits), until one converges. If none does, returns the result with the smallest error.
/// @param starts  largest number of starts. For legs of six or seven joints, a random start reaches a random pose in
/// six
///                of ten cases; with a hundred starts, one pose in ten thousand is missed.
DampedSearch SearchPose(const LegChain& chain, const Pose& X_BF, const VectorX& lower, const VectorX& upper,
                        const VectorX& guess, int starts);

}  // namespace gaitwright
