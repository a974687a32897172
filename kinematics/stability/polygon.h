// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/spatial/convex_hull.h"

namespace gaitwright {

// All functions here expect a polygon from ConvexHull.

/// Signed distance of a point to the boundary: positive inside, negative outside; never positive for a segment or
/// point.
/// @throws InvalidArgument for an empty polygon.
double SignedDistance(const Polygon& polygon, const Vector2& point);

/// The point of a polygon that is nearest to a point.
Vector2 NearestPoint(const Polygon& polygon, const Vector2& point);

/// The part of a polygon (three or more corners) where normal . p >= least; empty if there is no such part.
Polygon Clipped(const Polygon& polygon, const Vector2& normal, double least);

/// The polygon with every edge moved inward by `margin_m`; empty if nothing is left.
Polygon Shrunk(const Polygon& polygon, double margin_m);

/// Mean of the corners weighted by area (polygon), middle (segment).
Vector2 Centroid(const Polygon& polygon);

}  // namespace gaitwright
