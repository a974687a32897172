// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/swing/swing_planes.h"

#include <algorithm>
#include <limits>

namespace gaitwright {
namespace {

/// The corners of a patch.
std::vector<Vector3> CornersOfPatch(const TerrainPatch& patch) {
  std::vector<Vector3> corners_W;
  for (const Vector2& corner : patch.outline_T) corners_W.push_back(patch.X_WT * Vector3(corner.x(), corner.y(), 0.0));
  return corners_W;
}

/// The vertical plane through an edge, with the patch behind it; the outline is counter-clockwise from above.
PartingPlane SideAt(const Vector3& from_W, const Vector3& to_W) {
  const Vector3 along = to_W - from_W;
  const Vector3 out = Vector3(along.y(), -along.x(), 0.0).normalized();
  return {out, out.dot(from_W)};
}

/// The plane through the point of an edge that is nearest to p, perpendicular to the line to p. @return false if it
/// does not separate p from the solid.
bool EdgeBefore(const std::vector<Vector3>& corners_W, std::size_t edge, const Vector3& p_W, PartingPlane& plane) {
  constexpr double kTouching = 1e-9, kRounding = 1e-9;  // [m]
  const Vector3 &from = corners_W[edge], &to = corners_W[(edge + 1) % corners_W.size()];
  const Vector3 along = to - from;
  const double share = std::clamp((p_W - from).dot(along) / along.squaredNorm(), 0.0, 1.0);
  const Vector3 nearest = from + share * along;
  const double away_m = (p_W - nearest).norm();
  if (away_m < kTouching) return false;
  plane.normal_W = (p_W - nearest) / away_m;
  plane.offset_m = plane.normal_W.dot(nearest);
  return plane.normal_W.z() >= 0.0 && std::all_of(corners_W.begin(), corners_W.end(), [&](const Vector3& corner_W) {
           return plane.Beyond(corner_W) < kRounding;
         });
}

}  // namespace

PartingPlane PlaneBefore(const TerrainPatch& patch, const Vector3& p_W) {
  const Vector3 up = patch.X_WT.linear().col(2);
  PartingPlane best{up, up.dot(patch.X_WT.translation())};
  const auto take = [&](const PartingPlane& plane) {
    if (plane.Beyond(p_W) > best.Beyond(p_W)) best = plane;
  };
  const std::vector<Vector3> corners_W = CornersOfPatch(patch);
  for (std::size_t i = 0; i < corners_W.size(); ++i) {
    take(SideAt(corners_W[i], corners_W[(i + 1) % corners_W.size()]));
    PartingPlane edge;
    if (EdgeBefore(corners_W, i, p_W, edge)) take(edge);
  }
  return best;
}

PartingPlane PlaneBefore(const TerrainPatch& patch, const std::vector<Vector3>& path_W) {
  PartingPlane nearest;
  double least_m = std::numeric_limits<double>::infinity();
  for (const Vector3& p_W : path_W) {
    const PartingPlane plane = PlaneBefore(patch, p_W);
    if (plane.Beyond(p_W) >= least_m) continue;
    least_m = plane.Beyond(p_W);
    nearest = plane;
  }
  return nearest;
}

}  // namespace gaitwright
