// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/spatial/pose.h"

namespace gaitwright {

/// The plane in which a flat body comes to rest on points of the ground under a load at one place: no point is above
/// the plane, and the plane is as low as possible at the load, so it touches three points around the load. Solved by
/// the simplex method on
///   max sum w_i z_i  with  sum w_i (x_i, y_i, 1) = (load, 1),  w >= 0,
/// the dual of that problem.
/// @param ground_W  [m]; the load must lie between three of the first four points, such as the corners of a sole.
/// @return a, b, c of z = a x + b y + c.
/// @throws InvalidArgument if the load does not lie between three of the first four points.
Vector3 RestingPlane(const std::vector<Vector3>& ground_W, const Vector2& load_W);

}  // namespace gaitwright
