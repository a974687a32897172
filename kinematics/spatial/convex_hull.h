// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/spatial/pose.h"

namespace gaitwright {

/// A convex set in the plane: a polygon (three or more corners, counter-clockwise), a segment (two), a point (one) or
/// nothing. ConvexHull creates it; kinematics/stability/polygon.h has its queries.
using Polygon = std::vector<Vector2>;

/// Convex hull, counter-clockwise, without collinear corners (tolerance 1e-12 m^2). Andrew, Inf. Proc. Letters 9(5)
/// 1979.
Polygon ConvexHull(std::vector<Vector2> points);

/// The z component of a x b.
inline double Cross(const Vector2& a, const Vector2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Area [m^2], negative for clockwise corners; zero for segments and points.
double Area(const Polygon& polygon);

/// Area of an outline over the area of its convex hull. For a convex outline, it is 1 (counter-clockwise) or -1
/// (clockwise), up to rounding. For other outlines, its magnitude differs from 1; 0 without area.
double ShareOfHull(const std::vector<Vector2>& outline);

}  // namespace gaitwright
