// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/spatial/pose.h"

namespace gaitwright {

/// Rotation vector [rad] to rotation matrix; exact near zero.
Matrix3 RotationExp(const Vector3& rotation_vector);

/// Rotation vector [rad] of a rotation matrix, length in [0, pi]; exact near zero.
Vector3 RotationLog(const Matrix3& R);

/// The smallest rotation from the direction of a to that of b.
Quaternion RotationBetween(const Vector3& a, const Vector3& b);

/// Heading of a frame: the angle of its x axis in the horizontal plane [rad], in (-pi, pi].
double YawOf(const Matrix3& R_WB);

/// Rotation about z [rad].
Matrix3 YawRotation(double yaw_rad);

/// The angle plus the multiple of 2 pi that brings it into (-pi, pi].
double WrapAngle(double angle_rad);

/// [a]x, so that Skew(a) * b = a x b.
Matrix3 Skew(const Vector3& a);

}  // namespace gaitwright
