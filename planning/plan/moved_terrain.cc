// SPDX-License-Identifier: BSD-3-Clause
#include "planning/plan/moved_terrain.h"

#include <fmt/format.h>

#include <cmath>

#include "kinematics/spatial/rotation.h"

namespace gaitwright {

Result<Terrain> MovedTerrain(const Pose& X, Terrain terrain) {
  constexpr double kTurned = 1e-9;  // [rad]
  const double up_m = X.translation().z();
  for (TerrainPatch& patch : terrain.patches) {
    const bool same_all_over = patch.outline_T.empty() && patch.X_WT.linear().col(2) == Vector3::UnitZ();
    if (same_all_over) {
      patch.X_WT.translation().z() += up_m;
    } else {
      patch.X_WT = X * patch.X_WT;
    }
  }
  for (HeightField& field : terrain.height_fields) {
    if (std::abs(YawOf(X.linear())) > kTurned) {
      return Failure{
          FailureKind::kInfeasible,
          FailureCode::kTurnedField,
          "MovedTerrain",
          fmt::format("height field '{}' cannot be rotated, so the robot cannot walk on it after a turn", field.name),
          {"cross it before turning, or use a ground of patches"}};
    }
    field.origin_W += X.translation().head<2>();
    for (double& height_m : field.height_m) height_m += up_m;
  }
  for (Obstacle& obstacle : terrain.obstacles) obstacle.X_WO = X * obstacle.X_WO;
  for (TerrainMarker& marker : terrain.markers)
    marker.p_W = (X * Vector3(marker.p_W.x(), marker.p_W.y(), 0.0)).head<2>();
  return terrain;
}

}  // namespace gaitwright
