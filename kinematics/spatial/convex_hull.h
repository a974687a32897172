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

/// a x b, the z of it.
inline double Cross(const Vector2& a, const Vector2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Area [m^2], negative when the corners run clockwise; zero for segments and points.
double Area(const Polygon& polygon);

/// Share of its convex hull that an outline fills, with the sign of its area: 1 to rounding when it is convex and runs
/// counter-clockwise, -1 when it is convex and runs clockwise, something else when it is not convex; 0 without area.
double ShareOfHull(const std::vector<Vector2>& outline);

}  // namespace gaitwright
