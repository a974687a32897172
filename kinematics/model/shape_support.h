// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// The point of a shape that is farthest along a direction, both in S [m]; the origin for a mesh without vertices.
Vector3 SupportPoint(const Shape& shape, const Vector3& direction_S);

/// Radius of a sphere about the origin of S that contains the shape [m].
double BoundingRadius(const Shape& shape);

}  // namespace gaitwright
