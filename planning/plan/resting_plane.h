// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/spatial/pose.h"

namespace gaitwright {

/// The plane in which something flat comes to rest on points of the ground when it is loaded at one place: on top of
/// all of them and as low there as can be, so that it touches three around it. By the simplex method on
///   max sum w_i z_i  with  sum w_i (x_i, y_i, 1) = (load, 1),  w >= 0,
/// whose dual it is.
/// @param ground_W  [m]; three of the first four have the load between them, such as the corners of a sole.
/// @return a, b, c of z = a x + b y + c.
/// @throws InvalidArgument where no three of the first four have the load between them.
Vector3 RestingPlane(const std::vector<Vector3>& ground_W, const Vector2& load_W);

}  // namespace gaitwright
