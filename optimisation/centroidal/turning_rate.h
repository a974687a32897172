// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/spatial/pose.h"

namespace gaitwright {

/// d(angles)/dt of a body with angular momentum l: E^-1 I^-1 R^T l.
/// @param inverse_B  of the inertia in B; over the mean inertia where l is.
Vector3 AngleRates(const Matrix3& inverse_B, const Vector3& angles_rad, const Vector3& momentum);

/// The same with its derivatives.
struct TurningRate {
  Vector3 rate;
  Matrix3 by_angles, by_momentum;
};

/// Rate of the angles and its derivatives.
TurningRate TurningRateOf(const Matrix3& inverse_B, const Vector3& angles_rad, const Vector3& momentum);

}  // namespace gaitwright
