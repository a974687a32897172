// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "kinematics/base/random.h"
#include "planning/plan/built_in_terrain.h"
#include "planning/plan/terrain_shapes.h"
#include "planning/terrain/written_ground.h"

// Grounds that the tests of the writers write and read back.
namespace gaitwright::written_terrain {

inline Terrain BuiltIn(const std::string& name) {
  const Result<Terrain> made = MakeTerrain(name, {});
  EXPECT_TRUE(made.ok()) << made.failure().message;
  return made.ok() ? *made : Terrain{};
}

inline TerrainPatch Rectangle(const std::string& name, const Vector2& low, const Vector2& high, double height,
                              double friction = 0.8) {
  return PatchThrough(name,
                      {{low.x(), low.y(), height},
                       {high.x(), low.y(), height},
                       {high.x(), high.y(), height},
                       {low.x(), high.y(), height}},
                      friction);
}

/// Heights without a flat part.
inline HeightField Hills(const Vector2& origin, double resolution, int columns, int rows) {
  HeightField field;
  field.name = "hills";
  field.origin_W = origin;
  field.resolution_m = resolution;
  field.columns = columns;
  field.rows = rows;
  SplitMix random(7);
  for (int i = 0; i < columns * rows; ++i) field.height_m.push_back(0.1 + 0.2 * random.Uniform());
  return field;
}

/// Random places within the extent of a ground.
inline std::vector<Vector2> PlacesOn(const Terrain& terrain, int count) {
  const Eigen::AlignedBox2d extent = ExtentOf(terrain, false);
  SplitMix random(3);
  std::vector<Vector2> places;
  for (int i = 0; i < count; ++i) {
    const double x = random.Uniform(), y = random.Uniform();
    places.emplace_back(extent.min() + extent.sizes().cwiseProduct(Vector2(x, y)));
  }
  return places;
}

/// Whether a place is below or above an obstacle, or nearer to one than a distance along x and y.
inline bool IsNearObstacle(const Terrain& terrain, const Vector2& p, double distance) {
  for (const Obstacle& obstacle : terrain.obstacles) {
    Eigen::AlignedBox2d box;
    for (const Vector3& corner : CornersOf(obstacle)) box.extend(Vector2(corner.head<2>()));
    if (box.exteriorDistance(p) < distance) return true;
  }
  return false;
}

}  // namespace gaitwright::written_terrain
