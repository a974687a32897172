// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/stability/zero_moment_point.h"

#include "kinematics/base/result.h"

namespace gaitwright {

Vector2 ZeroMomentPoint(const Vector3& p_WP, const Vector3& force_W, const Vector3& moment_W, double ground_height_m) {
  if (!(force_W.z() > 0.0)) throw InvalidArgument("ZeroMomentPoint: the normal force must be positive");
  const double h = p_WP.z() - ground_height_m;
  return {p_WP.x() - (moment_W.y() + h * force_W.x()) / force_W.z(),
          p_WP.y() + (moment_W.x() - h * force_W.y()) / force_W.z()};
}

Vector3 ZeroMomentPoint(const Vector3& p_WP, const Vector3& force_W, const Vector3& moment_W,
                        const GroundPlane& plane) {
  const Vector3 n(-plane.slope.x(), -plane.slope.y(), 1.0);
  const double pressing = n.dot(force_W);
  if (!(pressing > 0.0)) throw InvalidArgument("ZeroMomentPoint: the normal force must be positive");
  return p_WP + (n.cross(moment_W) + (plane.height_m - n.dot(p_WP)) * force_W) / pressing;
}

Vector2 PendulumZmp(const Vector3& p_WC, const Vector3& a_WC, double omega_rad_s) {
  return p_WC.head<2>() - a_WC.head<2>() / (omega_rad_s * omega_rad_s);
}

Vector2 DivergentComponent(const Vector3& p_WC, const Vector3& v_WC, double omega_rad_s) {
  return p_WC.head<2>() + v_WC.head<2>() / omega_rad_s;
}

}  // namespace gaitwright
