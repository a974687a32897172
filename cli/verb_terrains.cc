// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "cli/flags.h"
#include "cli/ground_file.h"
#include "cli/json_text_internal.h"
#include "cli/paths.h"
#include "cli/program.h"
#include "cli/robot_input.h"
#include "cli/terrain_picture.h"
#include "kinematics/base/file.h"
#include "planning/plan/built_in_terrain.h"
#include "planning/terrain/load_terrain.h"
#include "workflows/walk/walk.h"

namespace gaitwright::cli {
namespace {

using Json = nlohmann::ordered_json;

struct TerrainsSettings {
  Common common;
  RobotFlags robot;
  std::string terrain, picture, out;
};

Json ParametersJson(const std::vector<TerrainParameter>& parameters) {
  Json list = Json::array();
  for (const TerrainParameter& p : parameters) {
    list.push_back({{"key", p.key},
                    {"value", p.value},
                    {"unit", p.unit},
                    {"lowest", p.lowest},
                    {"highest", p.highest},
                    {"meaning", p.meaning}});
  }
  return list;
}

void PrintParameters(const std::vector<TerrainParameter>& parameters) {
  for (const TerrainParameter& p : parameters) {
    const std::string unit = p.unit == "1" ? "" : " " + p.unit;
    fmt::print("  {:<16} {:<10} {} ({} to {})\n", p.key, p.value + unit, p.meaning, p.lowest, p.highest);
  }
}

int ListTerrains(const Common& common) {
  Json list = Json::array();
  for (const BuiltInTerrain& entry : BuiltInTerrains()) {
    std::string keys;
    const Result<std::vector<TerrainParameter>> parameters = TerrainParameters(entry.name, {});
    if (!parameters) return Report(parameters.failure(), common);
    Json names = Json::array();
    for (const TerrainParameter& parameter : *parameters) {
      keys += (keys.empty() ? "" : ", ") + parameter.key;
      names.push_back(parameter.key);
    }
    list.push_back({{"name", entry.name}, {"description", entry.description}, {"parameters", names}});
    if (common.json) continue;
    if (common.quiet) {
      fmt::print("{}\n", entry.name);
    } else {
      fmt::print("{:<16} {}\n{:<16}   {}\n", entry.name, entry.description, "", keys);
    }
  }
  if (common.json) PrintJson(Json{{"terrains", list}});
  return kPass;
}

/// The corners of a patch in W, as [x, y, z].
Json CornersJson(const TerrainPatch& patch) {
  Json corners = Json::array();
  for (const Vector2& corner_T : patch.outline_T) {
    const Vector3 p = patch.X_WT * Vector3(corner_T.x(), corner_T.y(), 0.0);
    corners.push_back({p.x(), p.y(), p.z()});
  }
  return corners;
}

Json PatchJson(const TerrainPatch& patch) {
  const Vector3 origin = patch.X_WT.translation(), normal = patch.X_WT.linear().col(2);
  return {{"name", patch.name},
          {"origin_m", {origin.x(), origin.y(), origin.z()}},
          {"normal", {normal.x(), normal.y(), normal.z()}},
          {"outline_m", CornersJson(patch)},
          {"friction", patch.friction}};
}

/// Lowest and highest of a field.
std::pair<double, double> HeightRange(const HeightField& field) {
  const auto [low, high] = std::minmax_element(field.height_m.begin(), field.height_m.end());
  return {*low, *high};
}

Json FieldJson(const HeightField& field) {
  const auto [low, high] = HeightRange(field);
  return {{"name", field.name},
          {"origin_m", {field.origin_W.x(), field.origin_W.y()}},
          {"resolution_m", field.resolution_m},
          {"columns", field.columns},
          {"rows", field.rows},
          {"lowest_m", low},
          {"highest_m", high},
          {"friction", field.friction}};
}

Json ObstacleJson(const Obstacle& obstacle) {
  const Vector3 p = obstacle.X_WO.translation();
  Json json = {
      {"name", obstacle.name}, {"type", ObstacleTypeName(obstacle.type)}, {"position_m", {p.x(), p.y(), p.z()}}};
  if (obstacle.type == ShapeType::kMesh) {
    json["vertices"] = obstacle.vertices_O.size();
  } else {
    json["size_m"] = {obstacle.size_m.x(), obstacle.size_m.y()};
    if (obstacle.type == ShapeType::kBox) json["size_m"].push_back(obstacle.size_m.z());
  }
  return json;
}

void PrintParts(const Terrain& terrain) {
  fmt::print("surfaces (the highest counts where they overlap)\n");
  for (const TerrainPatch& patch : terrain.patches) {
    const Vector3 origin = patch.X_WT.translation(), normal = patch.X_WT.linear().col(2);
    fmt::print("  {}: through ({:.3f}, {:.3f}, {:.3f}) m, normal ({:.3f}, {:.3f}, {:.3f}), {}, friction {}\n",
               patch.name, origin.x(), origin.y(), origin.z(), normal.x(), normal.y(), normal.z(),
               patch.outline_T.empty() ? "infinite" : fmt::format("{} corners", patch.outline_T.size()),
               patch.friction);
  }
  for (const HeightField& field : terrain.height_fields) {
    const auto [low, high] = HeightRange(field);
    fmt::print("  {}: {} by {} points {} m apart from ({:.3f}, {:.3f}) m, {:.3f} to {:.3f} m high, friction {}\n",
               field.name, field.columns, field.rows, field.resolution_m, field.origin_W.x(), field.origin_W.y(), low,
               high, field.friction);
  }
  if (!terrain.markers.empty()) fmt::print("markers\n");
  for (const TerrainMarker& marker : terrain.markers)
    fmt::print("  {}: at ({:.3f}, {:.3f}) m\n", marker.name, marker.p_W.x(), marker.p_W.y());
  if (!terrain.obstacles.empty()) fmt::print("obstacles\n");
  for (const Obstacle& obstacle : terrain.obstacles) {
    const Vector3 p = obstacle.X_WO.translation();
    const std::string size =
        obstacle.type == ShapeType::kMesh ? fmt::format("of {} points", obstacle.vertices_O.size())
        : obstacle.type == ShapeType::kBox
            ? fmt::format("{:.3f} by {:.3f} by {:.3f} m", obstacle.size_m.x(), obstacle.size_m.y(), obstacle.size_m.z())
            : fmt::format("radius {:.3f} m, {:.3f} m long", obstacle.size_m.x(), obstacle.size_m.y());
    fmt::print("  {}: {} {} at ({:.3f}, {:.3f}, {:.3f}) m\n", obstacle.name, ObstacleTypeName(obstacle.type), size,
               p.x(), p.y(), p.z());
  }
}

/// A ground with the sizes for a robot, and the files made from it.
struct ShownTerrain {
  std::string description;
  std::vector<TerrainParameter> parameters;
  Terrain terrain;
  GroundFiles written = {};
};

Json ShownTerrainJson(const ShownTerrain& shown, const std::string& robot, const TerrainsSettings& a) {
  Json patches = Json::array(), fields = Json::array(), obstacles = Json::array(), markers = Json::array(),
       files = Json::object();
  for (const TerrainPatch& patch : shown.terrain.patches) patches.push_back(PatchJson(patch));
  for (const HeightField& field : shown.terrain.height_fields) fields.push_back(FieldJson(field));
  for (const Obstacle& obstacle : shown.terrain.obstacles) obstacles.push_back(ObstacleJson(obstacle));
  for (const TerrainMarker& marker : shown.terrain.markers)
    markers.push_back({{"name", marker.name}, {"position_m", {marker.p_W.x(), marker.p_W.y()}}});
  if (!a.picture.empty()) files["picture"] = a.picture;
  if (!a.out.empty()) files["ground"] = a.out;
  Json json = {{"name", shown.terrain.name},
               {"description", shown.description},
               {"robot", robot},
               {"parameters", ParametersJson(shown.parameters)},
               {"patches", patches},
               {"height_fields", fields},
               {"obstacles", obstacles},
               {"markers", markers},
               {"files", files}};
  if (!shown.written.terrain.empty()) json["terrain"] = shown.written.terrain;
  if (!a.out.empty()) json["notes"] = shown.written.notes;
  return json;
}

Result<ShownTerrain> LookAtTerrain(const std::string& text, const TerrainScale& scale) {
  Result<Terrain> terrain = LoadTerrain(text, scale);
  if (!terrain) return terrain.failure();
  ShownTerrain shown{"ground of a file", {}, std::move(*terrain)};
  if (!TerrainFileOf(text).empty()) return shown;
  const std::string name = text.substr(0, text.find(':'));
  for (const BuiltInTerrain& entry : BuiltInTerrains()) {
    if (entry.name == name) shown.description = entry.description;
  }
  Result<std::vector<TerrainParameter>> parameters = TerrainParameters(text, scale);
  if (!parameters) return parameters.failure();
  shown.parameters = std::move(*parameters);
  return shown;
}

/// Makes the requested files and writes all of them or none.
Result<std::vector<std::string>> WriteFilesOf(ShownTerrain& shown, const TerrainScale& scale,
                                              const TerrainsSettings& a) {
  if (!a.out.empty()) {
    Result<GroundFiles> made = MakeGroundFiles(shown.terrain, a.out);
    if (!made) return made.failure();
    shown.written = std::move(*made);
  }
  std::vector<OutputFile> files = shown.written.files;
  if (!a.picture.empty()) files.push_back({a.picture, TerrainPicture(shown.terrain, scale)});
  return WriteFilesTogether(files);
}

void PrintShownTerrain(const ShownTerrain& shown, const std::string& robot, const std::vector<std::string>& files) {
  fmt::print("{}: {}\n", shown.terrain.name, shown.description);
  if (!shown.parameters.empty()) fmt::print("parameters, with the sizes for {}\n", robot);
  PrintParameters(shown.parameters);
  PrintParts(shown.terrain);
  for (const std::string& file : files) fmt::print("wrote {}\n", file);
  for (const std::string& note : shown.written.notes) fmt::print("note: {}\n", note);
  if (!shown.written.terrain.empty()) fmt::print("read it back with --terrain {}\n", shown.written.terrain);
}

int ShowTerrain(const TerrainsSettings& a) {
  Paths paths;
  a.robot.AddTo(paths);
  paths.AddTerrain(a.terrain);
  paths.Write("--picture", a.picture, {".svg"});
  paths.WriteByEnding("--out", a.out, {".xml", ".obj", ".png"});
  CheckPaths(paths);
  const Result<RobotModel> model = ReadRobot(a.robot);
  if (!model) return Report(model.failure(), a.common);
  const TerrainScale scale = ScaleOf(*model);
  Result<ShownTerrain> shown = LookAtTerrain(a.terrain, scale);
  if (!shown) return Report(shown.failure(), a.common);
  const Result<std::vector<std::string>> written = WriteFilesOf(*shown, scale, a);
  if (!written) return Report(written.failure(), a.common);
  if (a.common.json) {
    PrintJson(ShownTerrainJson(*shown, model->name, a));
  } else if (a.common.quiet) {
    fmt::print("{}\n", shown->terrain.name);
  } else {
    PrintShownTerrain(*shown, model->name, *written);
  }
  return kPass;
}

}  // namespace

void AddTerrains(Verb program, int& status) {
  auto a = std::make_shared<TerrainsSettings>();
  const Verb verb = program.AddVerb("terrains", "List the grounds; 'terrains show X' describes one");
  const Verb show = verb.AddVerb("show", "Describe one ground: its sizes, surfaces and obstacles");
  AddText(show, "TERRAIN", "NAME", a->terrain,
          "A name from 'gaitwright terrains', with or without parameters, or a file, as for --terrain; see "
          "docs/terrain-format.md.")
      .Require();
  a->robot.AddTo(show, "Robot whose size sets the default dimensions; default a1.");
  AddText(show, "--picture", "FILE", a->picture, "Draw the ground into this SVG file, from above and from the side.");
  AddText(
      show, "--out", "FILE", a->out,
      "Write the ground for other programs. The ending decides the format: .xml (MuJoCo's MJCF), .obj (triangles) or "
      ".png (16-bit greyscale heights); see docs/terrain-format.md.");
  AddCommon(verb, a->common, {"terrains", "terrains show stairs"});
  AddCommon(show, a->common,
            {"terrains show stairs --robot nao", "terrains show rough:amplitude_m=0.03,seed=2 --picture rough.svg",
             "terrains show stairs --out stairs.xml"});
  verb.RequireVerbs(0, 1);
  SetWork(verb, a->common, status, [a] { return a->terrain.empty() ? ListTerrains(a->common) : ShowTerrain(*a); });
}

}  // namespace gaitwright::cli
