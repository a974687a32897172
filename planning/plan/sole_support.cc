// SPDX-License-Identifier: BSD-3-Clause
#include "planning/plan/sole_support.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

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

/// Height of a point of a sole above the ground; infinity without ground.
double GapAt(const Vector2& p_F, const Pose& X_WF, const Terrain& terrain) {
  const Vector3 p_W = X_WF * Vector3(p_F.x(), p_F.y(), 0.0);
  const GroundPoint ground = GroundAt(terrain, p_W.head<2>());
  return ground.patch < 0 ? std::numeric_limits<double>::infinity() : p_W.z() - ground.height_m;
}

}  // namespace

bool LiesOn(const TerrainPatch& patch, const Pose& X_WF, double most_tilt_rad) {
  return patch.X_WT.linear().col(2).cross(X_WF.linear().col(2)).norm() <= most_tilt_rad;
}

Polygon TouchingCorners(const std::vector<Vector2>& sole_F, const Pose& X_WF, const Terrain& terrain) {
  constexpr double kTouching = 2e-3;  // [m]
  Polygon touching;
  for (const Vector2& corner : sole_F) {
    if (std::abs(GapAt(corner, X_WF, terrain)) <= kTouching) touching.push_back(corner);
  }
  return touching;
}

std::vector<Vector2> SoleSamples(const std::vector<Vector2>& sole_F, double spacing_m) {
  constexpr double kMost = 24.0;   // samples along one side
  constexpr double kTiny = 1e-12;  // [m]
  std::vector<Vector2> samples = sole_F;
  const Eigen::AlignedBox2d box = [&] {
    Eigen::AlignedBox2d around;
    for (const Vector2& corner : sole_F) around.extend(corner);
    return around;
  }();
  const double step = std::max(spacing_m, box.sizes().maxCoeff() / kMost);
  const int columns = static_cast<int>(std::ceil(box.sizes().x() / step)),
            rows = static_cast<int>(std::ceil(box.sizes().y() / step));
  for (int i = 0; i <= columns; ++i) {
    for (int j = 0; j <= rows; ++j) {
      const Vector2 share(static_cast<double>(i) / columns, static_cast<double>(j) / rows);
      const Vector2 p = box.min() + share.cwiseProduct(box.sizes());
      const bool corner = std::ranges::any_of(sole_F, [&](const Vector2& c) { return (c - p).norm() < kTiny; });
      if (!corner && SignedDistance(sole_F, p) > -kTiny) samples.push_back(p);
    }
  }
  return samples;
}

Polygon TouchingPart(const std::vector<Vector2>& sole_F, const Pose& X_WF, const Terrain& terrain,
                     double resolution_m) {
  constexpr double kTouching = 5e-4;  // [m]
  std::vector<Vector2> touching;
  for (const Vector2& p_F : SoleSamples(sole_F, kSoleSampling * resolution_m)) {
    if (std::abs(GapAt(p_F, X_WF, terrain)) <= kTouching) touching.push_back(p_F);
  }
  return ConvexHull(std::move(touching));
}

Polygon SteadyPart(const std::vector<Vector2>& sole_F, const Pose& X_WF, const Terrain& terrain, double resolution_m) {
  constexpr double kExactly = 2e-5;  // [m]
  constexpr double kRocks = 5e-3;    // [rad]
  std::vector<std::pair<double, Vector2>> gaps;
  double least = std::numeric_limits<double>::infinity();
  for (const Vector2& p_F : SoleSamples(sole_F, kSoleSampling * resolution_m)) {
    gaps.emplace_back(GapAt(p_F, X_WF, terrain), p_F);
    least = std::min(least, gaps.back().first);
  }
  Polygon part;
  for (const auto& [gap, p_F] : gaps)
    if (gap - least <= kExactly) part.push_back(p_F);
  const Polygon touching = ConvexHull(part);
  for (const auto& [gap, p_F] : gaps)
    if (!touching.empty() && gap - least <= -kRocks * SignedDistance(touching, p_F)) part.push_back(p_F);
  return ConvexHull(std::move(part));
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
  if (foot.has_sole() && surface < patches && !LiesOn(terrain.patches[surface], foothold.X_WF))
    return TouchingCorners(foot.sole_F, foothold.X_WF, terrain);
  if (foot.type == FootType::kSole && surface >= patches)
    return TouchingPart(foot.sole_F, foothold.X_WF, terrain, terrain.height_fields[surface - patches].resolution_m);
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
