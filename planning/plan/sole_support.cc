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

namespace {

/// The grid of a height field as a level patch, for its edges.
TerrainPatch GridOf(const HeightField& field) {
  TerrainPatch grid;
  const Vector2 low = field.origin_W;
  const Vector2 high = low + field.resolution_m * Vector2(field.columns - 1, field.rows - 1);
  grid.outline_T = {low, {high.x(), low.y()}, high, {low.x(), high.y()}};
  return grid;
}

}  // namespace

Polygon SupportOf(const Foot& foot, const Foothold& foothold, const Terrain& terrain, double margin_m) {
  if (foothold.patch < 0 || foothold.patch >= terrain.num_surfaces()) return {};
  const auto surface = static_cast<std::size_t>(foothold.patch), patches = terrain.patches.size();
  return PartOnPatch(foot.has_sole() ? foot.sole_F : std::vector<Vector2>{Vector2::Zero()}, foothold.X_WF,
                     surface < patches ? terrain.patches[surface] : GridOf(terrain.height_fields[surface - patches]),
                     margin_m);
}

std::vector<Polygon> SupportsOf(const RobotModel& model, const Terrain& terrain, const FootstepPlan& footsteps) {
  std::vector<Polygon> supports;
  for (const Foothold& foothold : footsteps.footholds) {
    const Foot& foot = model.feet[static_cast<std::size_t>(foothold.foot)];
    Polygon support = foot.has_sole() ? SupportOf(foot, foothold, terrain) : Polygon{Vector2::Zero()};
    if (support.empty()) support = foot.sole_F;
    supports.push_back(std::move(support));
  }
  return supports;
}

}  // namespace gaitwright
