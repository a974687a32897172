// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/spatial/pose.h"

namespace gaitwright {

/// A convex set in the plane: a polygon (three or more corners, counter-clockwise), a segment (two), a point (one) or
/// nothing. ConvexHull makes one; every other function here expects one.
using Polygon = std::vector<Vector2>;

/// Convex hull, counter-clockwise, without collinear corners (tolerance 1e-12 m^2). Andrew, Inf. Proc. Letters 9(5)
/// 1979.
Polygon ConvexHull(std::vector<Vector2> points);

/// Area [m^2]; zero for segments and points.
double Area(const Polygon& polygon);

/// Signed distance of a point to the edge: positive inside, negative outside; never positive for a segment or a point.
/// @throws InvalidArgument for an empty polygon.
double SignedDistance(const Polygon& polygon, const Vector2& point);

/// The member nearest to a point.
Vector2 NearestPoint(const Polygon& polygon, const Vector2& point);

/// The part of a polygon (three or more corners) where normal . p >= least; empty when there is none.
Polygon Clipped(const Polygon& polygon, const Vector2& normal, double least);

/// The polygon moved inward by `margin_m` on every edge; empty when nothing is left.
Polygon Shrunk(const Polygon& polygon, double margin_m);

/// Mean of the corners weighted by area (polygon), middle (segment).
Vector2 Centroid(const Polygon& polygon);

}  // namespace gaitwright
