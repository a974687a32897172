// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/spatial/convex_hull.h"

namespace gaitwright {

/// A box along x and y.
struct PlanBox {
  Vector2 lowest = Vector2::Zero(), highest = Vector2::Zero();
};

/// The box around points, with a margin [m].
PlanBox BoxOf(const Polygon& points, double margin_m);

/// True when a straight strip of at least `gap_m` along an edge of one of them parts two convex outlines, each
/// counter-clockwise with one corner or more. Never true for outlines that are nearer than the gap; corner against
/// corner it may miss a little more than the gap.   Gottschalk et al., SIGGRAPH 1996: separating axes.
bool ApartBy(const Polygon& a, const Polygon& b, double gap_m);

/// The outline, counter-clockwise with three corners or more, moved outward by `margin_m` on every edge; fewer corners
/// become the square around them.
Polygon Widened(const Polygon& outline, double margin_m);

/// Share of the outline that a part covers: of the area, or of the length for a line.
double ShareOf(const Polygon& part, const Polygon& outline);

/// How far an outline about the origin goes in a direction, at least zero [m].
double ReachOf(const Polygon& outline, const Vector2& direction);

/// How far the origin has to be inside of an edge for a share of the outline about it to be inside [m]; negative where
/// it may be outside.
/// @param inward  unit normal of the edge.
double DepthOfShare(const Polygon& outline, const Vector2& inward, double share);

}  // namespace gaitwright
