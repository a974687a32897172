// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/spatial/rotation.h"

#include <cmath>
#include <numbers>

namespace gaitwright {

Matrix3 RotationExp(const Vector3& rotation_vector) {
  const double angle = rotation_vector.norm();
  const double half = 0.5 * angle;
  const double scale = angle < 1e-6 ? 0.5 - angle * angle / 48.0 : std::sin(half) / angle;
  const Vector3 xyz = scale * rotation_vector;
  return Quaternion(std::cos(half), xyz.x(), xyz.y(), xyz.z()).toRotationMatrix();
}

Vector3 RotationLog(const Matrix3& R) {
  Quaternion quaternion(R);
  if (quaternion.w() < 0.0) quaternion.coeffs() *= -1.0;
  const double sine = quaternion.vec().norm();
  if (sine < 1e-9) return 2.0 * quaternion.vec();
  return 2.0 * std::atan2(sine, quaternion.w()) / sine * quaternion.vec();
}

Quaternion RotationBetween(const Vector3& a, const Vector3& b) { return Quaternion::FromTwoVectors(a, b); }

double YawOf(const Matrix3& R_WB) { return std::atan2(R_WB(1, 0), R_WB(0, 0)); }

Matrix3 YawRotation(double yaw_rad) { return Eigen::AngleAxisd(yaw_rad, Vector3::UnitZ()).toRotationMatrix(); }

double WrapAngle(double angle_rad) {
  const double wrapped = std::remainder(angle_rad, 2.0 * std::numbers::pi);
  return wrapped <= -std::numbers::pi ? std::numbers::pi : wrapped;
}

Matrix3 Skew(const Vector3& a) {
  Matrix3 m;
  m << 0.0, -a.z(), a.y(), a.z(), 0.0, -a.x(), -a.y(), a.x(), 0.0;
  return m;
}

}  // namespace gaitwright
