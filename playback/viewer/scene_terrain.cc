// SPDX-License-Identifier: BSD-3-Clause
#include "playback/viewer/packed_columns_internal.h"
#include "playback/viewer/scene_parts_internal.h"

namespace gaitwright {
namespace {

using Json = nlohmann::ordered_json;

Json PatchJson(const TerrainPatch& patch) {
  Json outline = Json::array();
  for (const Vector2& corner : patch.outline_T) outline.push_back({corner.x(), corner.y()});
  return {{"name", patch.name}, {"pose", PoseJson(patch.X_WT)}, {"outline_m", outline}};
}

Json FieldJson(const HeightField& field) {
  const std::vector<float> heights(field.height_m.begin(), field.height_m.end());
  return {{"name", field.name},
          {"origin_m", {field.origin_W.x(), field.origin_W.y()}},
          {"resolution_m", field.resolution_m},
          {"columns", field.columns},
          {"rows", field.rows},
          {"heights_m", Packed(1, heights)}};
}

Json ObstacleJson(const Obstacle& obstacle) {
  const bool hull = obstacle.type == ShapeType::kMesh;
  Json json = {{"name", obstacle.name},
               {"type", hull ? "hull" : ObstacleTypeName(obstacle.type)},
               {"pose", PoseJson(obstacle.X_WO)},
               {"size_m", {obstacle.size_m.x(), obstacle.size_m.y(), obstacle.size_m.z()}}};
  if (hull) json["points_m"] = PackedPoints(obstacle.vertices_O);
  return json;
}

}  // namespace

Json TerrainScene(const Terrain& terrain) {
  Json patches = Json::array(), fields = Json::array(), obstacles = Json::array();
  for (const TerrainPatch& patch : terrain.patches) patches.push_back(PatchJson(patch));
  for (const HeightField& field : terrain.height_fields) fields.push_back(FieldJson(field));
  for (const Obstacle& obstacle : terrain.obstacles) obstacles.push_back(ObstacleJson(obstacle));
  return {{"name", terrain.name}, {"patches", patches}, {"height_fields", fields}, {"obstacles", obstacles}};
}

}  // namespace gaitwright
