// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/base/result.h"
#include "kinematics/spatial/pose.h"

namespace gaitwright {

/// A convex piece of walkable plane. T: origin in the plane, z its outward normal.
struct TerrainPatch {
  std::string name;
  Pose X_WT = Pose::Identity();
  std::vector<Vector2> outline_T;  ///< counter-clockwise; empty for a plane without end
  double friction = 0.8;
};

/// The ground, as one value for planner, optimiser, audit, Bullet and viewer.
/// Where patches overlap in plan view the highest one holds.
struct Terrain {
  std::string name;
  std::vector<TerrainPatch> patches;
};

/// Level ground without end at z = 0.
Terrain FlatTerrain(double friction = 0.8);

/// A ground that comes with the program.
struct BuiltInTerrain {
  std::string name;
  std::string description;
  Terrain terrain;
};

/// The one list of built-in grounds.
std::vector<BuiltInTerrain> BuiltInTerrains();

/// The built-in terrain of that name. An unknown name is a failure that lists what exists.
Result<Terrain> FindTerrain(const std::string& name);

/// The ground under a point in plan view.
struct GroundPoint {
  int patch = -1;  ///< index into patches; -1 where there is no ground
  double height_m = 0.0;
  Vector3 normal_W = Vector3::UnitZ();
  double friction = 0.0;
};

/// The highest ground at (x, y); patch -1 where there is none.
GroundPoint GroundAt(const Terrain& terrain, const Vector2& p_W);

}  // namespace gaitwright
