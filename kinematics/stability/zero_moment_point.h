// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/spatial/pose.h"

namespace gaitwright {

/// Zero-moment point of a contact wrench on level ground: the point where its horizontal moment is zero,
///   Z_x = p_x - (M_y + h F_x) / F_z,   Z_y = p_y + (M_x - h F_y) / F_z,   h = p_z - ground height.
/// @param p_WP, force_W, moment_W  the wrench: its reference point [m], force [N] and moment about P [N m].
/// @throws InvalidArgument unless force_W.z() > 0.   Sardain and Bessonnet, IEEE T-SMC A 34(5), 2004.
Vector2 ZeroMomentPoint(const Vector3& p_WP, const Vector3& force_W, const Vector3& moment_W, double ground_height_m);

/// A plane that is not vertical: z = height_m + slope . (x, y), in W.
struct GroundPlane {
  double height_m = 0.0;  ///< height at the origin of W [m]
  Vector2 slope = Vector2::Zero();

  /// Height at a point in plan view [m].
  double HeightAt(const Vector2& p_W) const { return height_m + slope.dot(p_W); }
};

/// Zero-moment point on a plane with normal n: its point Z about which the moment is along n,
///   Z - P = (n x M + s F) / (n . F),   s the distance from P up to the plane, in units of n.
/// On a plane through two contact points, without other forces, Z is on the line between them.
/// @return Z [m]; its z is the plane's.   Caron et al., T-RO 33(1), 2017, doi:10.1109/TRO.2016.2623338.
/// @throws InvalidArgument unless the force presses on the plane.
Vector3 ZeroMomentPoint(const Vector3& p_WP, const Vector3& force_W, const Vector3& moment_W, const GroundPlane& plane);

/// Zero-moment point of the linear inverted pendulum, p_WC - a_WC / omega^2 (x and y).
/// Kajita et al., ICRA 2003, doi:10.1109/ROBOT.2003.1241826.
Vector2 PendulumZmp(const Vector3& p_WC, const Vector3& a_WC, double omega_rad_s);

/// Divergent component of motion, p_WC + v_WC / omega (x and y). Englsberger et al., T-RO 31(2), 2015.
Vector2 DivergentComponent(const Vector3& p_WC, const Vector3& v_WC, double omega_rad_s);

}  // namespace gaitwright
