// SPDX-License-Identifier: BSD-3-Clause
#include "planning/plan/terrain_shapes.h"

#include <fmt/format.h>

#include <numbers>
#include <string>
#include <vector>

#include "kinematics/model/shape_support.h"

namespace gaitwright {
namespace {

std::string NameOf(const std::string& name, const char* kind, std::size_t number) {
  return name.empty() ? fmt::format("{} {}", kind, number) : name;
}

/// A convex hull in W, stored relative to its centre, so that rounding does not grow with the distance from the origin
/// of W.
Shape HullShape(const std::vector<Vector3>& corners_W) {
  Shape shape;
  shape.type = ShapeType::kMesh;
  Vector3 middle = Vector3::Zero();
  for (const Vector3& corner : corners_W) middle += corner / static_cast<double>(corners_W.size());
  for (const Vector3& corner : corners_W) shape.vertices.push_back(corner - middle);
  shape.X_BS.translation() = middle;
  return shape;
}

}  // namespace

FixedSolids ConvexSolidsOf(const Terrain& terrain) {
  FixedSolids solids;
  for (std::size_t i = 0; i < terrain.patches.size(); ++i) {
    const TerrainPatch& patch = terrain.patches[i];
    const std::string name = NameOf(patch.name, "patch", i);
    if (patch.outline_T.empty()) {
      const Vector3 normal_W = patch.X_WT.linear().col(2);
      solids.half_spaces.push_back({name, normal_W, normal_W.dot(patch.X_WT.translation())});
    } else {
      solids.shapes.push_back(HullShape(SolidUnder(patch)));
      solids.shapes.back().link = name;
    }
  }
  for (std::size_t i = 0; i < terrain.obstacles.size(); ++i) {
    solids.shapes.push_back(ShapeOf(terrain.obstacles[i]));
    solids.shapes.back().link = NameOf(terrain.obstacles[i].name, "obstacle", i);
  }
  return solids;
}

ShapeScene SolidsOf(const Terrain& terrain) {
  const FixedSolids solids = ConvexSolidsOf(terrain);
  std::vector<GridSolid> grids;
  for (std::size_t i = 0; i < terrain.height_fields.size(); ++i) {
    const HeightField& field = terrain.height_fields[i];
    grids.push_back({NameOf(field.name, "height field", i), field.origin_W, field.resolution_m, field.columns,
                     field.rows, field.height_m, kSolidDepth});
  }
  return ShapeScene(solids.shapes, grids, solids.half_spaces);
}

std::vector<Vector2> PlanOutline(const TerrainPatch& patch) {
  std::vector<Vector2> outline;
  for (const Vector2& corner : patch.outline_T)
    outline.emplace_back((patch.X_WT * Vector3(corner.x(), corner.y(), 0.0)).head<2>());
  return outline;
}

std::vector<Vector3> CornersOf(const Obstacle& obstacle) {
  std::vector<Vector3> corners = obstacle.vertices_O;
  if (obstacle.type == ShapeType::kBox) {
    corners = BoxCorners(obstacle.size_m);
  } else if (obstacle.type == ShapeType::kCylinder) {
    constexpr int kSides = 32;
    for (int i = 0; i < 2 * kSides; ++i) {
      const int side = i / 2;
      const double turn = 2.0 * std::numbers::pi * side / kSides, r = obstacle.size_m.x();
      corners.emplace_back(r * std::cos(turn), r * std::sin(turn), (i % 2 - 0.5) * obstacle.size_m.y());
    }
  }
  for (Vector3& corner : corners) corner = obstacle.X_WO * corner;
  return corners;
}

}  // namespace gaitwright
