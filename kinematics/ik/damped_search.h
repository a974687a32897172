// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/ik/leg_chain.h"

namespace gaitwright {

/// Result of a descent.
struct DampedSearch {
  VectorX coordinates;
  bool converged = false;
  double distance_m = 0.0, angle_rad = 0.0;  ///< left between foot and target, controlled rows only
  int iterations = 0;
};

/// Brings the foot of a leg to a pose by damped least squares within limits, from a start inside of them:
///   step = J^T (J J^T + lambda 1)^-1 e,  positions scaled by the leg's length.
/// Lambda falls with the square of the error, so the end is Newton's (1e-11), and rises where a step does not help.
/// A coordinate at its limit is taken out while the error pushes it on. The loop allocates nothing.
///
/// Levenberg-Marquardt as in Sugihara, IEEE T-RO 27(5), 2011, doi:10.1109/TRO.2011.2148230.
DampedSearch DescendToPose(const LegChain& chain, const Pose& X_BF, const VectorX& lower, const VectorX& upper,
                           const VectorX& start);

/// Searches from a guess, then from the standing posture, then from seeded random positions within the limits (a full
/// turn for joints without limits), until one converges; otherwise the result with the smallest error.
/// @param starts  how many of them at most. A random place leads to a random pose of a leg of six or seven joints in
///                six of ten cases, so a hundred miss one pose in ten thousand.
DampedSearch SearchPose(const LegChain& chain, const Pose& X_BF, const VectorX& lower, const VectorX& upper,
                        const VectorX& guess, int starts);

}  // namespace gaitwright
