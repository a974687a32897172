// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/spatial/pose.h"

namespace gaitwright {

/// A convex set in the plane: a polygon (three or more corners, counter-clockwise), a segment (two), a point (one) or
/// nothing. ConvexHull makes one; kinematics/stability/polygon.h asks about it.
using Polygon = std::vector<Vector2>;

/// Convex hull, counter-clockwise, without collinear corners (tolerance 1e-12 m^2). Andrew, Inf. Proc. Letters 9(5)
/// 1979.
Polygon ConvexHull(std::vector<Vector2> points);

/// Area [m^2]; zero for segments and points.
double Area(const Polygon& polygon);

}  // namespace gaitwright
