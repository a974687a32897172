// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// The point of a shape that lies farthest along a direction, both in S [m]; of a mesh without vertices the origin.
Vector3 SupportPoint(const Shape& shape, const Vector3& direction_S);

/// Radius about the origin of S that holds the whole shape [m].
double BoundingRadius(const Shape& shape);

}  // namespace gaitwright
