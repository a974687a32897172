// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/spatial/convex_hull.h"

namespace gaitwright {

/// A box with sides along x and y.
struct PlanBox {
  Vector2 lowest = Vector2::Zero(), highest = Vector2::Zero();
};

/// The box around points, with a margin [m].
PlanBox BoxOf(const Polygon& points, double margin_m);

/// True if a straight strip of width `gap_m` or more along an edge of one outline separates two convex outlines (each
/// counter-clockwise with one corner or more). Never true for outlines nearer than the gap; between two corners it may
/// be false although the distance is slightly more than the gap. Gottschalk et al., SIGGRAPH 1996: separating axes.
bool ApartBy(const Polygon& a, const Polygon& b, double gap_m);

/// The outline, counter-clockwise with three corners or more, with each edge moved outward by `margin_m`. With fewer
/// corners, the square around them.
Polygon Widened(const Polygon& outline, double margin_m);

/// Share of the outline that a part covers: of the area, or of the length of a line.
double ShareOf(const Polygon& part, const Polygon& outline);

/// Extent of an outline around the origin in a direction, at least zero [m].
double ReachOf(const Polygon& outline, const Vector2& direction);

/// Depth of the origin inside of an edge at which a share of the outline around it is inside [m]; negative if the
/// origin may be outside.
/// @param inward  unit normal of the edge.
double DepthOfShare(const Polygon& outline, const Vector2& inward, double share);

}  // namespace gaitwright
