// SPDX-License-Identifier: BSD-3-Clause
#include "planning/plan/terrain.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "kinematics/base/result.h"
#include "kinematics/spatial/convex_hull.h"

namespace gaitwright {

GroundKind KindOfGround(const Terrain& terrain) {
  constexpr double kLevel = 1.0 - 1e-12;  // cosine of the tilt of level ground, less rounding
  if (terrain.patches.size() != 1 || !terrain.height_fields.empty() || !terrain.obstacles.empty())
    return GroundKind::kUneven;
  const TerrainPatch& patch = terrain.patches.front();
  const Vector3 normal_W = patch.X_WT.linear().col(2);
  if (normal_W.z() <= kLevel) return GroundKind::kUneven;
  if (!patch.outline_T.empty()) return GroundKind::kBounded;
  const bool is_flat = normal_W == Vector3::UnitZ() && patch.X_WT.translation().z() == 0.0;
  return is_flat ? GroundKind::kFlat : GroundKind::kLevel;
}

Terrain FlatTerrain(double friction) {
  TerrainPatch ground;
  ground.name = "ground";
  ground.friction = friction;
  return {"flat", {ground}, {}, {}};
}

TerrainPatch PatchThrough(const std::string& name, const std::vector<Vector3>& corners_W, double friction) {
  constexpr double kFlat = 1e-3;      // [m]
  constexpr double kRounding = 1e-6;  // of the share of the hull
  const auto refuse = [&](const std::string& why) { throw InvalidArgument(fmt::format("patch '{}' {}", name, why)); };
  if (corners_W.size() < 3) refuse(fmt::format("has {} corners; three or more are needed", corners_W.size()));
  Vector3 middle = Vector3::Zero(), normal = Vector3::Zero();  // normal by Newell's sum over edges
  for (std::size_t i = 0; i < corners_W.size(); ++i) {
    middle += corners_W[i] / static_cast<double>(corners_W.size());
    normal += (corners_W[i] - corners_W[0]).cross(corners_W[(i + 1) % corners_W.size()] - corners_W[0]);
  }
  if (!(normal.z() > 1e-9 * normal.norm())) refuse("does not run counter-clockwise around an area in plan view");
  TerrainPatch patch;
  patch.name = name;
  patch.friction = friction;
  patch.X_WT.translation() = middle;
  const Vector3 z = normal.normalized(), x = Vector3::UnitY().cross(z).normalized();
  patch.X_WT.linear() << x, z.cross(x), z;
  for (const Vector3& corner : corners_W) {
    const Vector3 p_T = patch.X_WT.inverse() * corner;
    if (std::abs(p_T.z()) > kFlat)
      refuse(fmt::format("is not flat: a corner is {:.4g} m off its plane; {} m is accepted", p_T.z(), kFlat));
    patch.outline_T.emplace_back(p_T.head<2>());
  }
  const double share = ShareOfHull(patch.outline_T);
  if (std::abs(share - 1.0) > kRounding)
    refuse(fmt::format("covers {:.4g} of its convex hull; it must be convex", std::abs(share)));
  return patch;
}

namespace {

/// The height and normal of a height field at a point; patch is -1 outside of its grid.
GroundPoint FieldAt(const HeightField& field, const Vector2& p_W) {
  const Vector2 at = (p_W - field.origin_W) / field.resolution_m;
  if (!(at.x() >= 0.0 && at.y() >= 0.0 && at.x() <= field.columns - 1 && at.y() <= field.rows - 1)) return {};
  const int column = std::min(static_cast<int>(at.x()), field.columns - 2);
  const int row = std::min(static_cast<int>(at.y()), field.rows - 2);
  const auto height = [&](int dx, int dy) {
    return field.height_m[static_cast<std::size_t>((row + dy) * field.columns + column + dx)];
  };
  const double u = at.x() - column, v = at.y() - row, low = height(0, 0), high = height(1, 1);
  const double corner = u >= v ? height(1, 0) : height(0, 1);  // of the triangle that contains the point
  const double by_x = u >= v ? corner - low : high - corner, by_y = u >= v ? high - corner : corner - low;
  const Vector3 normal(-by_x, -by_y, field.resolution_m);
  return {0, low + u * by_x + v * by_y, normal.normalized(), field.friction};
}

/// Whether a point is in a convex outline or on its edge, with a tolerance, so that no gap is left between neighbours.
bool Holds(const std::vector<Vector2>& outline, const Vector2& p) {
  constexpr double kSeam = 1e-9;  // [m]
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vector2 edge = outline[(i + 1) % outline.size()] - outline[i];
    const double side = Cross(edge, p - outline[i]);
    if (side < 0.0 && side * side > kSeam * kSeam * edge.squaredNorm()) return false;
  }
  return true;
}

/// The height and normal of a patch at a point; patch is -1 outside of its outline.
GroundPoint PatchAt(const TerrainPatch& patch, const Vector2& p_W) {
  const Vector3 normal = patch.X_WT.linear().col(2);
  const Vector3 origin = patch.X_WT.translation();
  const double height = origin.z() - normal.head<2>().dot(p_W - origin.head<2>()) / normal.z();
  if (!patch.outline_T.empty()) {
    const Vector3 p_T = patch.X_WT.inverse() * Vector3(p_W.x(), p_W.y(), height);
    if (!Holds(patch.outline_T, p_T.head<2>())) return {};
  }
  return {0, height, normal, patch.friction};
}

}  // namespace

GroundPoint GroundAt(const Terrain& terrain, const Vector2& p_W) {
  GroundPoint highest;
  const auto take = [&](const GroundPoint& point, std::size_t surface) {
    if (point.patch < 0 || (highest.patch >= 0 && point.height_m <= highest.height_m)) return;
    highest = point;
    highest.patch = static_cast<int>(surface);
  };
  for (std::size_t i = 0; i < terrain.patches.size(); ++i) take(PatchAt(terrain.patches[i], p_W), i);
  for (std::size_t i = 0; i < terrain.height_fields.size(); ++i)
    take(FieldAt(terrain.height_fields[i], p_W), terrain.patches.size() + i);
  return highest;
}

double FrictionOf(const Terrain& terrain, int surface) {
  if (surface < 0 || surface >= terrain.num_surfaces()) return 0.0;
  const auto i = static_cast<std::size_t>(surface), patches = terrain.patches.size();
  return i < patches ? terrain.patches[i].friction : terrain.height_fields[i - patches].friction;
}

std::vector<Vector3> SolidUnder(const TerrainPatch& patch) {
  std::vector<Vector3> corners;
  for (const Vector2& corner_T : patch.outline_T) {
    const Vector3 top = patch.X_WT * Vector3(corner_T.x(), corner_T.y(), 0.0);
    corners.push_back(top);
    corners.emplace_back(top - kSolidDepth * Vector3::UnitZ());
  }
  return corners;
}

const std::vector<ShapeType>& ObstacleTypes() {
  static const std::vector<ShapeType> types = {ShapeType::kBox, ShapeType::kCylinder, ShapeType::kMesh};
  return types;
}

const std::vector<std::string>& ObstacleTypeNames() {
  static const std::vector<std::string> names = {"box", "cylinder", "mesh"};
  return names;
}

const std::string& ObstacleTypeName(ShapeType type) {
  for (std::size_t i = 0; i < ObstacleTypes().size(); ++i) {
    if (ObstacleTypes()[i] == type) return ObstacleTypeNames()[i];
  }
  throw InvalidArgument("an obstacle is a sphere or a capsule; it must be a box, a cylinder or a mesh");
}

Shape ShapeOf(const Obstacle& obstacle) {
  Shape shape;
  shape.type = obstacle.type;
  shape.link = obstacle.name;
  shape.X_BS = obstacle.X_WO;
  shape.size = obstacle.size_m;
  shape.vertices = obstacle.vertices_O;
  return shape;
}

}  // namespace gaitwright
