// SPDX-License-Identifier: BSD-3-Clause
#include "planning/plan/sole_support.h"

#include "kinematics/stability/polygon.h"

namespace gaitwright {

Polygon PartOnPatch(const std::vector<Vector2>& sole_F, const Pose& X_WF, const TerrainPatch& patch, double margin_m) {
  Polygon part = sole_F;
  const std::size_t corners = patch.outline_T.size();
  const Pose X_FT = X_WF.inverse() * patch.X_WT;
  for (std::size_t i = 0; i < corners && !part.empty(); ++i) {
    const Vector2 &a = patch.outline_T[i], &b = patch.outline_T[(i + 1) % corners];
    const Vector3 p_F = X_FT * Vector3(a.x(), a.y(), 0.0);
    const Vector2 along = (X_FT.linear() * Vector3(b.x() - a.x(), b.y() - a.y(), 0.0)).head<2>().normalized();
    const Vector2 inward(-along.y(), along.x());
    part = Clipped(part, inward, inward.dot(p_F.head<2>()) + margin_m);
  }
  return ConvexHull(part);
}

Polygon SupportOf(const Foot& foot, const Foothold& foothold, const Terrain& terrain, double margin_m) {
  if (!foot.has_sole()) return {Vector2::Zero()};
  const auto surface = static_cast<std::size_t>(foothold.patch);
  if (foothold.patch < 0 || surface >= terrain.patches.size()) return ConvexHull(foot.sole_F);
  return PartOnPatch(foot.sole_F, foothold.X_WF, terrain.patches[surface], margin_m);
}

}  // namespace gaitwright
