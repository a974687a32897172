// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "planning/plan/terrain.h"

namespace gaitwright {

/// A wall from a to b on the ground, 1 m high.
inline Obstacle Wall(const std::string& name, const Vector2& a, const Vector2& b, double thickness = 0.1) {
  Obstacle wall;
  wall.name = name;
  wall.type = ShapeType::kBox;
  const Vector2 middle = 0.5 * (a + b);
  wall.X_WO.translation() = Vector3(middle.x(), middle.y(), 0.5);
  wall.X_WO.linear() = Eigen::AngleAxisd(std::atan2(b.y() - a.y(), b.x() - a.x()), Vector3::UnitZ()).toRotationMatrix();
  wall.size_m = Vector3((b - a).norm(), thickness, 1.0);
  return wall;
}

/// Level ground with walls.
inline Terrain Walled(std::vector<Obstacle> walls) {
  Terrain terrain = FlatTerrain();
  terrain.name = "walled";
  terrain.obstacles = std::move(walls);
  return terrain;
}

/// A level rectangle at a height.
inline TerrainPatch Slab(const std::string& name, const Vector2& low, const Vector2& high, double height = 0.0) {
  TerrainPatch slab;
  slab.name = name;
  slab.X_WT.translation() = Vector3(low.x(), low.y(), height);
  const Vector2 size = high - low;
  slab.outline_T = {{0.0, 0.0}, {size.x(), 0.0}, size, {0.0, size.y()}};
  return slab;
}

/// Walls across the path, each with one opening of the same width, alternately on the left and on the right, and walls
/// along both sides. The route from the origin's lane to the last one is about (lanes - 1) * (half_width + lane) long.
inline Terrain Switchback(int lanes, double lane, double half_width, double opening) {
  std::vector<Obstacle> walls;
  const double begin = -0.5 * lane, end = (lanes - 0.5) * lane;
  walls.push_back(Wall("left side", {begin, half_width}, {end, half_width}));
  walls.push_back(Wall("right side", {begin, -half_width}, {end, -half_width}));
  walls.push_back(Wall("near end", {begin, -half_width}, {begin, half_width}));
  walls.push_back(Wall("far end", {end, -half_width}, {end, half_width}));
  for (int i = 0; i + 1 < lanes; ++i) {
    const double x = (i + 0.5) * lane, sign = i % 2 == 0 ? 1.0 : -1.0;
    walls.push_back(Wall("wall " + std::to_string(i + 1), {x, -sign * half_width}, {x, sign * (half_width - opening)}));
  }
  return Walled(std::move(walls));
}

}  // namespace gaitwright
