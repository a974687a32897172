// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// The point of a shape that is farthest along a direction, both in S [m]; the origin for a mesh without vertices.
Vector3 SupportPoint(const Shape& shape, const Vector3& direction_S);

/// The eight corners of a box with these edge lengths, about its centre [m].
std::vector<Vector3> BoxCorners(const Vector3& size_m);

/// Radius of a sphere about the origin of S that contains the shape [m].
double BoundingRadius(const Shape& shape);

}  // namespace gaitwright
