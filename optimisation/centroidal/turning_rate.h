// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/spatial/pose.h"

namespace gaitwright {

/// d(angles)/dt of a body with angular momentum l: E^-1 I^-1 R^T l.
/// @param inverse_B  of the inertia in B; divided by the mean inertia if l is.
Vector3 AngleRates(const Matrix3& inverse_B, const Vector3& angles_rad, const Vector3& momentum);

/// Rate of the angles with its derivatives.
struct TurningRate {
  Vector3 rate;
  Matrix3 by_angles, by_momentum;
};

/// Rate of the angles and its derivatives.
TurningRate TurningRateOf(const Matrix3& inverse_B, const Vector3& angles_rad, const Vector3& momentum);

/// Angles of a body and its angular momentum at one time.
struct TurningState {
  const Vector3 &angles_rad, &momentum;
};

/// Angles at a share u of an interval of length h by Hermite's cubic, from the angles and momenta at both ends, with
/// their derivatives.
struct AnglesBetween {
  AnglesBetween(const Matrix3& inverse_B, double h, double u, const TurningState& from, const TurningState& to);

  TurningRate rate_from, rate_to;
  Vector3 value;
  Matrix3 by_from, by_to, by_l_from, by_l_to;
};

}  // namespace gaitwright
