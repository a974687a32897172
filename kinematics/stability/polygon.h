// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/spatial/convex_hull.h"

namespace gaitwright {

// Every function here expects a polygon as ConvexHull makes it.

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
