// SPDX-License-Identifier: BSD-3-Clause
#include "planning/plan/foothold_support.h"

#include "kinematics/stability/polygon.h"

namespace gaitwright {
namespace {

/// The part of a polygon in F on the left of a line from a to b, given in the frame that X_TF leads to, in plan view.
Polygon LeftOf(const Polygon& polygon_F, const Pose& X_TF, const Vector2& a, const Vector2& b, double margin_m) {
  const Vector2 along = (b - a).normalized(), inward(-along.y(), along.x());
  const Vector2 normal_F = X_TF.linear().topLeftCorner<2, 2>().transpose() * inward;
  const double least = inward.dot(a) + margin_m - inward.dot(X_TF.translation().head<2>());
  if (polygon_F.size() >= 3) return Clipped(polygon_F, normal_F, least);
  Polygon kept;
  for (const Vector2& p : polygon_F) {
    if (normal_F.dot(p) >= least) kept.push_back(p);
  }
  return kept;
}

}  // namespace

Polygon SupportedSole(const Terrain& terrain, const Foot& foot, const Foothold& foothold, double margin_m) {
  Polygon part = foot.sole_F.empty() ? Polygon{Vector2::Zero()} : ConvexHull(foot.sole_F);
  if (foothold.patch < 0 || foothold.patch >= terrain.num_surfaces()) return {};
  const auto surface = static_cast<std::size_t>(foothold.patch);
  std::vector<Vector2> outline;
  Pose X_WT = Pose::Identity();
  if (surface < terrain.patches.size()) {
    outline = terrain.patches[surface].outline_T;
    X_WT = terrain.patches[surface].X_WT;
  } else {
    const HeightField& field = terrain.height_fields[surface - terrain.patches.size()];
    const Vector2 size = field.resolution_m * Vector2(field.columns - 1, field.rows - 1);
    const Vector2 low = field.origin_W, high = low + size;
    outline = {low, {high.x(), low.y()}, high, {low.x(), high.y()}};
  }
  const Pose X_TF = X_WT.inverse() * foothold.X_WF;
  for (std::size_t i = 0; i < outline.size() && !part.empty(); ++i)
    part = LeftOf(part, X_TF, outline[i], outline[(i + 1) % outline.size()], margin_m);
  return ConvexHull(part);
}

}  // namespace gaitwright
