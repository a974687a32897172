// SPDX-License-Identifier: BSD-3-Clause
#include "planning/plan/terrain.h"

#include <fmt/format.h>

#include <algorithm>

#include "kinematics/base/options.h"
#include "kinematics/stability/polygon.h"

namespace gaitwright {

Terrain FlatTerrain(double friction) {
  TerrainPatch ground;
  ground.name = "ground";
  ground.friction = friction;
  return {"flat", {ground}, {}, {}};
}

std::vector<BuiltInTerrain> BuiltInTerrains() { return {{"flat", "level ground without end", FlatTerrain()}}; }

Result<Terrain> FindTerrain(const std::string& name) {
  std::vector<std::string> names;
  for (BuiltInTerrain& entry : BuiltInTerrains()) {
    if (entry.name == name) return std::move(entry.terrain);
    names.push_back(entry.name);
  }
  return Failure{FailureKind::kBadInput,
                 "unknown_terrain",
                 "FindTerrain",
                 fmt::format("there is no terrain '{}'; there is {}", name, QuotedList(names)),
                 {}};
}

namespace {

/// The height and normal of a height field at a point; patch stays -1 outside of its grid.
GroundPoint FieldAt(const HeightField& field, const Vector2& p_W) {
  const Vector2 at = (p_W - field.origin_W) / field.resolution_m;
  if (!(at.x() >= 0.0 && at.y() >= 0.0 && at.x() <= field.columns - 1 && at.y() <= field.rows - 1)) return {};
  const int column = std::min(static_cast<int>(at.x()), field.columns - 2);
  const int row = std::min(static_cast<int>(at.y()), field.rows - 2);
  const auto height = [&](int dx, int dy) {
    return field.height_m[static_cast<std::size_t>((row + dy) * field.columns + column + dx)];
  };
  const double u = at.x() - column, v = at.y() - row, low = height(0, 0), high = height(1, 1);
  const double corner = u >= v ? height(1, 0) : height(0, 1);  // of the triangle that holds the point
  const double by_x = u >= v ? corner - low : high - corner, by_y = u >= v ? high - corner : corner - low;
  const Vector3 normal(-by_x, -by_y, field.resolution_m);
  return {0, low + u * by_x + v * by_y, normal.normalized(), field.friction};
}

/// The height and normal of a patch at a point; patch stays -1 outside of its outline.
GroundPoint PatchAt(const TerrainPatch& patch, const Vector2& p_W) {
  const Vector3 normal = patch.X_WT.linear().col(2);
  const Vector3 origin = patch.X_WT.translation();
  const double height = origin.z() - normal.head<2>().dot(p_W - origin.head<2>()) / normal.z();
  if (!patch.outline_T.empty()) {
    const Vector3 p_T = patch.X_WT.inverse() * Vector3(p_W.x(), p_W.y(), height);
    if (SignedDistance(patch.outline_T, p_T.head<2>()) < 0.0) return {};
  }
  return {0, height, normal, patch.friction};
}

}  // namespace

GroundPoint GroundAt(const Terrain& terrain, const Vector2& p_W) {
  GroundPoint highest;
  const auto take = [&](GroundPoint point, std::size_t surface) {
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
