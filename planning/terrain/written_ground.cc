// SPDX-License-Identifier: BSD-3-Clause
#include "planning/terrain/written_ground.h"

#include <fmt/format.h>

#include <algorithm>

#include "planning/plan/terrain_shapes.h"

namespace gaitwright {

Eigen::AlignedBox2d ExtentOf(const Terrain& terrain, bool with_obstacles) {
  Eigen::AlignedBox2d extent;
  for (const TerrainPatch& patch : terrain.patches) {
    for (const Vector2& corner : PlanOutline(patch)) extent.extend(corner);
    if (!patch.outline_T.empty()) continue;
    extent.extend(Vector2::Constant(-0.5 * kKeptOfPlane));
    extent.extend(Vector2::Constant(0.5 * kKeptOfPlane));
  }
  for (const HeightField& field : terrain.height_fields) {
    extent.extend(field.origin_W);
    extent.extend(Vector2(field.origin_W + field.resolution_m * Vector2(field.columns - 1, field.rows - 1)));
  }
  if (extent.isEmpty() || !with_obstacles) return extent;
  for (const Obstacle& obstacle : terrain.obstacles) {
    for (const Vector3& corner : CornersOf(obstacle)) extent.extend(Vector2(corner.head<2>()));
  }
  return extent;
}

std::vector<std::string> NotesOfCutPlanes(const Terrain& terrain, const Eigen::AlignedBox2d& extent) {
  std::vector<std::string> notes;
  for (const TerrainPatch& patch : terrain.patches) {
    if (!patch.outline_T.empty()) continue;
    notes.push_back(
        fmt::format("the infinite surface '{}' is cut to x from {:.4g} to {:.4g} m and y from {:.4g} to "
                    "{:.4g} m",
                    patch.name, extent.min().x(), extent.max().x(), extent.min().y(), extent.max().y()));
  }
  return notes;
}

std::string FrictionParameter(const Terrain& terrain, std::vector<std::string>& notes) {
  double lowest = FrictionOf(terrain, 0), highest = lowest;
  for (int i = 1; i < terrain.num_surfaces(); ++i) {
    lowest = std::min(lowest, FrictionOf(terrain, i));
    highest = std::max(highest, FrictionOf(terrain, i));
  }
  if (lowest != highest) {
    notes.push_back(
        fmt::format("the file contains no friction coefficients, which are from {} to {}", lowest, highest));
  }
  return lowest == TerrainPatch{}.friction ? "" : fmt::format("friction={}", lowest);
}

}  // namespace gaitwright
