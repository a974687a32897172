// SPDX-License-Identifier: BSD-3-Clause
#include "planning/plan/terrain.h"

#include <fmt/format.h>

#include "kinematics/base/options.h"
#include "kinematics/stability/polygon.h"

namespace gaitwright {

Terrain FlatTerrain(double friction) {
  TerrainPatch ground;
  ground.name = "ground";
  ground.friction = friction;
  return {"flat", {ground}};
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

GroundPoint GroundAt(const Terrain& terrain, const Vector2& p_W) {
  GroundPoint highest;
  for (std::size_t i = 0; i < terrain.patches.size(); ++i) {
    const TerrainPatch& patch = terrain.patches[i];
    const Vector3 normal = patch.X_WT.linear().col(2);
    const Vector3 origin = patch.X_WT.translation();
    const double height = origin.z() - normal.head<2>().dot(p_W - origin.head<2>()) / normal.z();
    if (!patch.outline_T.empty()) {
      const Vector3 p_T = patch.X_WT.inverse() * Vector3(p_W.x(), p_W.y(), height);
      if (SignedDistance(patch.outline_T, p_T.head<2>()) < 0.0) continue;
    }
    if (highest.patch < 0 || height > highest.height_m) {
      highest = {static_cast<int>(i), height, normal, patch.friction};
    }
  }
  return highest;
}

}  // namespace gaitwright
