// SPDX-License-Identifier: BSD-3-Clause
#include "planning/terrain/terrain_yaml.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <numbers>

#include "kinematics/base/file.h"
#include "kinematics/base/options.h"
#include "kinematics/base/strict_yaml_internal.h"
#include "kinematics/base/text.h"
#include "planning/plan/built_in_terrain.h"
#include "planning/terrain/load_terrain.h"
#include "planning/terrain/sense.h"
#include "planning/terrain/terrain_yaml_shape.h"

namespace gaitwright {
namespace {

using Keys = std::vector<std::string>;

constexpr std::size_t kMostVertices = 10000;  // of an obstacle

DataShape FrictionShape() { return shapes::Number(kLeastFriction, kMostFriction); }

DataShape HeightShape() { return shapes::Number(-kHighest, kHighest); }

DataShape PatchShape() {
  using namespace shapes;
  return Object(
      {{"name", Text()},
       Optional("corners_m", List(Numbers(3), 3), "Corners in one plane, convex, counter-clockwise seen from above."),
       Optional("height_m", HeightShape(), "Height of an infinite level patch."),
       Optional("friction", FrictionShape(), "Friction coefficient; default 0.8.")},
      {{"corners_m", "height_m"}});
}

DataShape HeightFieldShape() {
  using namespace shapes;
  return Object(
      {{"name", Text()},
       {"origin_m", Numbers(2), "Position of the point with the lowest x and y."},
       {"resolution_m", Number(0.001, 1.0), "Distance between neighbouring points."},
       {"heights_m", List(List(HeightShape(), 2), 2), "Heights as seen from above: the first row has the highest y."},
       Optional("friction", FrictionShape(), "Friction coefficient; default 0.8.")});
}

DataShape ObstacleShape() {
  using namespace shapes;
  const DataShape angle = Number(-360.0, 360.0);
  return Object(
      {{"name", Text()},
       {"type", Text(ObstacleTypeNames())},
       Optional("size_m", List(Number(0.001, kFarthest), 2, 3),
                "Edge lengths of a box; radius and length of other shapes."),
       Optional("vertices_m", List(Numbers(3), 4, kMostVertices), "Vertices of a mesh; their convex hull is used."),
       Optional("position_m", Numbers(3), "Position of the centre; for a mesh, of its origin."),
       Optional("yaw_deg", angle, "Rotation about z, applied first."),
       Optional("pitch_deg", angle, "Rotation about y, applied second."),
       Optional("roll_deg", angle, "Rotation about x, applied last.")},
      {{"size_m", "vertices_m"}});
}

DataShape MarkerShape() { return shapes::Object({{"name", shapes::Text()}, {"place_m", shapes::Numbers(2)}}); }

/// `count` coordinates: x, y and, for three, z.
VectorX Place(const YAML::Node& node, const std::string& what, int count) {
  const std::vector<YAML::Node> parts = ListOf(node, what);
  if (static_cast<int>(parts.size()) != count)
    RefuseYaml(node, fmt::format("{} has {} numbers; {} are needed", what, parts.size(), count));
  VectorX place(count);
  for (int i = 0; i < count; ++i) {
    const double far = i < 2 ? kFarthest : kHighest;
    place[i] = NumberOf(parts[static_cast<std::size_t>(i)], what, -far, far);
  }
  return place;
}

std::vector<Vector3> Places(const YAML::Node& node, const std::string& what) {
  std::vector<Vector3> places;
  for (const YAML::Node& part : ListOf(node, what)) places.emplace_back(Place(part, what, 3));
  return places;
}

double FrictionOf(const YAML::Node& node) {
  return node["friction"] ? NumberOf(node["friction"], "friction", FrictionShape()) : 0.8;
}

/// Runs `make` and adds the line of `node` to its error.
template <class Make>
auto At(const YAML::Node& node, Make make) {
  try {
    return make();
  } catch (const InvalidArgument& error) {
    RefuseYaml(node, error.what());
  }
}

TerrainPatch ParsePatch(const YAML::Node& node) {
  const YamlMap checked(node, "a patch", PatchShape());
  const std::string name = TextOf(node["name"], "name");
  if (static_cast<bool>(node["corners_m"]) == static_cast<bool>(node["height_m"])) {
    RefuseYaml(node, fmt::format("patch '{}' needs either 'corners_m' or, if it is infinite, 'height_m'", name));
  }
  if (node["height_m"]) {
    TerrainPatch plane;
    plane.name = name;
    plane.friction = FrictionOf(node);
    plane.X_WT.translation().z() = NumberOf(node["height_m"], "height_m", HeightShape());
    return plane;
  }
  const std::vector<Vector3> corners = Places(node["corners_m"], "corners_m");
  const double friction = FrictionOf(node);
  return At(node, [&] { return PatchThrough(name, corners, friction); });
}

HeightField ParseHeights(const YAML::Node& node) {
  const DataShape shape = HeightFieldShape();
  const YamlMap checked(node, "a height field", shape);
  HeightField field;
  field.name = TextOf(node["name"], "name");
  field.origin_W = Place(node["origin_m"], "origin_m", 2);
  field.resolution_m = NumberOf(node["resolution_m"], "resolution_m", shape.At("resolution_m"));
  field.friction = FrictionOf(node);
  const std::vector<YAML::Node> rows = ListOf(node["heights_m"], "heights_m");
  for (std::size_t r = rows.size(); r-- > 0;) {  // as seen from above: the first row has the largest y
    const YAML::Node& row = rows[r];
    const std::vector<YAML::Node> cells = ListOf(row, "a row of heights_m");
    if (field.rows++ == 0) field.columns = static_cast<int>(cells.size());
    if (static_cast<int>(cells.size()) != field.columns)
      RefuseYaml(row, fmt::format("rows of heights_m have {} and {} numbers; all must have the same", cells.size(),
                                  field.columns));
    for (const YAML::Node& cell : cells) field.height_m.push_back(NumberOf(cell, "heights_m", HeightShape()));
  }
  if (field.rows < 2 || field.columns < 2) {
    RefuseYaml(node["heights_m"], fmt::format("heights_m has {} rows of {} numbers; at least two by two are needed",
                                              field.rows, field.columns));
  }
  return field;
}

Pose ParsePose(const YAML::Node& node) {
  Pose pose = Pose::Identity();
  if (node["position_m"]) pose.translation() = Place(node["position_m"], "position_m", 3);
  const auto turn = [&](const char* key, const Vector3& axis) {
    if (!node[key]) return;
    const double angle = NumberOf(node[key], key, ObstacleShape().At(key)) * std::numbers::pi / 180.0;
    pose.rotate(Eigen::AngleAxisd(angle, axis));
  };
  turn("yaw_deg", Vector3::UnitZ());
  turn("pitch_deg", Vector3::UnitY());
  turn("roll_deg", Vector3::UnitX());
  return pose;
}

TerrainMarker ParseMarker(const YAML::Node& node) {
  const YamlMap checked(node, "a marker", MarkerShape());
  TerrainMarker marker{TextOf(node["name"], "name"), Place(node["place_m"], "place_m", 2)};
  if (Trimmed(marker.name).empty()) RefuseYaml(node["name"], "a marker's name is empty");
  return marker;
}

Obstacle ParseObstacle(const YAML::Node& node) {
  const YamlMap checked(node, "an obstacle", ObstacleShape());
  Obstacle obstacle;
  obstacle.name = TextOf(node["name"], "name");
  const std::string type = TextOf(node["type"], "type");
  const Keys& types = ObstacleTypeNames();
  const auto at = std::find(types.begin(), types.end(), type);
  if (at == types.end()) RefuseYaml(node["type"], fmt::format("type is '{}'; accepted: {}", type, QuotedList(types)));
  obstacle.type = ObstacleTypes()[static_cast<std::size_t>(at - types.begin())];
  obstacle.X_WO = ParsePose(node);
  const bool mesh = obstacle.type == ShapeType::kMesh;
  const char* needed = mesh ? "vertices_m" : "size_m";
  if (!node[needed] || node[mesh ? "size_m" : "vertices_m"])
    RefuseYaml(node,
               fmt::format("obstacle '{}' is a {}; give '{}' and no other shape key", obstacle.name, type, needed));
  if (mesh) {
    obstacle.vertices_O = Places(node[needed], needed);
    if (obstacle.vertices_O.size() < 4 || obstacle.vertices_O.size() > kMostVertices)
      RefuseYaml(node[needed], fmt::format("vertices_m has {} points; four to {} are needed",
                                           obstacle.vertices_O.size(), kMostVertices));
    return obstacle;
  }
  const std::vector<YAML::Node> sizes = ListOf(node[needed], needed);
  const std::size_t count = obstacle.type == ShapeType::kBox ? 3 : 2;
  if (sizes.size() != count) {
    RefuseYaml(node[needed], fmt::format("size_m has {} numbers; a {} has {}", sizes.size(), type,
                                         count == 3 ? "three edges" : "a radius and a length"));
  }
  for (std::size_t i = 0; i < count; ++i)
    obstacle.size_m[static_cast<Eigen::Index>(i)] = NumberOf(sizes[i], "size_m", 0.001, kFarthest);
  return obstacle;
}

/// Refuses height fields with more points than allowed for one ground; the points of all files count.
void CheckNodes(const YAML::Node& node, const Terrain& terrain) {
  std::size_t nodes = 0;
  for (const HeightField& field : terrain.height_fields) nodes += field.height_m.size();
  if (nodes > static_cast<std::size_t>(kMostNodes)) {
    RefuseYaml(node, fmt::format("the height fields so far have {} points; accepted: at most {} points in all", nodes,
                                 kMostNodes));
  }
}

/// Adds another ground's parts.
void Append(const Terrain& from, Terrain& to) {
  to.patches.insert(to.patches.end(), from.patches.begin(), from.patches.end());
  to.height_fields.insert(to.height_fields.end(), from.height_fields.begin(), from.height_fields.end());
  to.obstacles.insert(to.obstacles.end(), from.obstacles.begin(), from.obstacles.end());
  to.markers.insert(to.markers.end(), from.markers.begin(), from.markers.end());
}

/// Path of a file that is named in another file of the given folder.
std::string BesideIt(const std::string& folder, const std::string& text) {
  return (std::filesystem::path(folder) / text).string();
}

/// A ground named at a node. A YAML file must not name another YAML file, because that could form a cycle.
Terrain Named(const YAML::Node& node, const std::string& folder, const TerrainScale& scale, bool file) {
  std::string text = TextOf(node, file ? "a file" : "builtin");
  if (file && (text.find(".yaml") != std::string::npos || text.find(".yml") != std::string::npos))
    RefuseYaml(node, fmt::format("'{}' is a YAML file; accepted: a height map or a mesh", text));
  if (file) text = BesideIt(folder, text);
  const Result<Terrain> terrain = file ? LoadTerrain(text, scale) : MakeTerrain(text, scale);
  if (!terrain) RefuseYaml(node, terrain.failure().message);
  return *terrain;
}

Terrain Parse(const YAML::Node& root, const std::string& folder, const TerrainScale& scale) {
  const YamlMap checked(root, "the file", TerrainFileShape());
  Terrain terrain;
  const auto each = [&](const char* key, auto add) {
    if (!root[key]) return;
    for (const YAML::Node& node : ListOf(root[key], key)) add(node);
  };
  if (root["builtin"]) Append(Named(root["builtin"], folder, scale, false), terrain);
  each("files", [&](const YAML::Node& node) {
    Append(Named(node, folder, scale, true), terrain);
    CheckNodes(node, terrain);
  });
  each("patches", [&](const YAML::Node& node) { terrain.patches.push_back(ParsePatch(node)); });
  each("height_fields", [&](const YAML::Node& node) { terrain.height_fields.push_back(ParseHeights(node)); });
  each("obstacles", [&](const YAML::Node& node) { terrain.obstacles.push_back(ParseObstacle(node)); });
  each("markers", [&](const YAML::Node& node) { terrain.markers.push_back(ParseMarker(node)); });
  if (terrain.num_surfaces() == 0)
    RefuseYaml(root, "there is no ground; give 'builtin', 'files', 'patches' or 'height_fields'");
  return terrain;
}

}  // namespace

DataShape TerrainFileShape() {
  using namespace shapes;
  return Object(
      {Optional("builtin", Text(), "Built-in ground to start from, as for --terrain."),
       Optional("files", List(Text()), "Height maps and meshes, with parameters; paths are relative to this file."),
       Optional("patches", List(PatchShape()), "Flat ground."),
       Optional("height_fields", List(HeightFieldShape()), "Ground as height fields."),
       Optional("obstacles", List(ObstacleShape()), "Obstacles, which must not be touched."),
       Optional("markers", List(MarkerShape()), "Named places, for instructions.")});
}

Result<Terrain> ReadTerrainYaml(const std::string& path, const TerrainScale& scale) {
  const auto bad = [&](const std::string& message) {
    return Failure{FailureKind::kBadInput,
                   FailureCode::kTerrainFile,
                   "ReadTerrainYaml",
                   fmt::format("'{}', {}", path, message),
                   {}};
  };
  const Result<std::string> text = ReadFile(path);
  if (!text) return text.failure();
  try {
    return Parse(LoadYaml(*text), std::filesystem::path(path).parent_path().string(), scale);
  } catch (const YAML::Exception& error) {
    return bad(fmt::format("line {}: not valid YAML from here on; see docs/terrain-format.md", error.mark.line + 1));
  } catch (const InvalidArgument& error) {
    return bad(error.what());
  }
}

std::vector<std::string> FilesOfTerrainYaml(const std::string& path) {
  const Result<std::string> text = ReadFile(path);
  if (!text) return {};
  std::vector<std::string> files;
  try {
    const YAML::Node root = LoadYaml(*text);
    if (!root.IsMap() || !root["files"]) return {};
    const std::string folder = std::filesystem::path(path).parent_path().string();
    for (const YAML::Node& node : ListOf(root["files"], "files"))
      files.push_back(BesideIt(folder, TextOf(node, "a file")));
  } catch (const YAML::Exception&) {  // errors are reported when the file is read as a ground
    return {};
  } catch (const InvalidArgument&) {
    return {};
  }
  return files;
}

}  // namespace gaitwright
