// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// Signed distance of two convex shapes:
///   d = max over unit vectors n of (min over b of n . p_Wb - max over a of n . p_Wa).
/// It is the distance of separated shapes, and minus the penetration depth of shapes that overlap.
struct ConvexDistance {
  double distance_m = 0.0;
  Vector3 n_W = Vector3::UnitZ();               ///< the n above, from A to B
  Vector3 p_WA = Vector3::Zero(), p_WB = p_WA;  ///< witness points on the surfaces: p_WB - p_WA = d n [m]
};

/// Exact up to rounding for boxes, spheres, capsules and meshes, and to 1e-10 m for cylinders. Separated shapes by the
/// algorithm of Gilbert, Johnson and Keerthi (IEEE J. Robotics and Automation 4(2), 1988); shapes that overlap by the
/// expanding polytope of van den Bergen (Game Developers Conference, 2001). A mesh without vertices is its origin.
ConvexDistance DistanceOf(const Shape& A, const Pose& X_WA, const Shape& B, const Pose& X_WB);

}  // namespace gaitwright
