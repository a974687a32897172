// SPDX-License-Identifier: BSD-3-Clause
#include "planning/terrain/write_obj.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "kinematics/base/distinct_names.h"
#include "kinematics/model/mesh_parts.h"
#include "kinematics/spatial/solid_hull.h"
#include "planning/plan/terrain_shapes.h"

namespace gaitwright {
namespace {

struct ObjGroup {
  std::string name;
  Mesh mesh;
};

/// A name without characters that have a meaning in an OBJ file.
std::string ObjName(std::string name) {
  for (char& c : name) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte <= 0x20 || byte == 0x7f || c == '\\' || c == '#') c = '_';
  }
  return name.empty() ? "ground" : name;
}

/// Top, sides and bottom of a patch, counter-clockwise as seen from outside.
Mesh SolidOfPatch(const TerrainPatch& patch) {
  Mesh mesh;
  mesh.vertices = SolidUnder(patch);  // for each corner of the outline: above, below
  const int n = static_cast<int>(patch.outline_T.size());
  for (int i = 1; i + 1 < n; ++i) mesh.triangles.emplace_back(0, 2 * i, 2 * i + 2);
  for (int i = 0; i < n; ++i) {
    const int top = 2 * i, next = 2 * ((i + 1) % n);
    mesh.triangles.emplace_back(top, top + 1, next + 1);
    mesh.triangles.emplace_back(top, next + 1, next);
  }
  for (int i = 1; i + 1 < n; ++i) mesh.triangles.emplace_back(1, 2 * i + 3, 2 * i + 1);
  return mesh;
}

/// The part of an infinite surface over a box.
TerrainPatch CutTo(const Eigen::AlignedBox2d& box, const TerrainPatch& plane) {
  const Vector3 origin = plane.X_WT.translation(), normal = plane.X_WT.linear().col(2);
  std::vector<Vector3> corners;
  for (const Vector2& p :
       {box.min(), Vector2(box.max().x(), box.min().y()), box.max(), Vector2(box.min().x(), box.max().y())})
    corners.emplace_back(p.x(), p.y(), origin.z() - normal.head<2>().dot(p - origin.head<2>()) / normal.z());
  return PatchThrough(plane.name, corners, plane.friction);
}

Mesh SurfaceOfField(const HeightField& field) {
  Mesh mesh;
  for (int row = 0; row < field.rows; ++row) {
    for (int column = 0; column < field.columns; ++column) {
      const Vector2 p = field.origin_W + field.resolution_m * Vector2(column, row);
      mesh.vertices.emplace_back(p.x(), p.y(), field.height_m[mesh.vertices.size()]);
      if (row + 1 == field.rows || column + 1 == field.columns) continue;
      const int low = row * field.columns + column, high = low + field.columns + 1;
      mesh.triangles.emplace_back(low, low + 1, high);
      mesh.triangles.emplace_back(low, high, high - 1);
    }
  }
  return mesh;
}

std::vector<ObjGroup> GroupsOf(const Terrain& terrain, const Eigen::AlignedBox2d& extent) {
  std::vector<ObjGroup> groups;
  for (const Obstacle& obstacle : terrain.obstacles) {
    const std::vector<Vector3> corners = CornersOf(obstacle);
    groups.push_back({ObjName(obstacle.name), {corners, HullTriangles(corners)}});
  }
  for (const TerrainPatch& patch : terrain.patches)
    groups.push_back({ObjName(patch.name), SolidOfPatch(patch.outline_T.empty() ? CutTo(extent, patch) : patch)});
  for (const HeightField& field : terrain.height_fields) groups.push_back({ObjName(field.name), SurfaceOfField(field)});
  std::vector<std::string> names;
  for (const ObjGroup& group : groups) names.push_back(group.name);
  names = DistinctNames(names, "_");
  for (std::size_t i = 0; i < groups.size(); ++i) groups[i].name = names[i];
  return groups;
}

std::string ObjText(const std::string& name, const std::vector<ObjGroup>& groups) {
  std::string text = fmt::format("# {}: metres, z up\n", ObjName(name));
  const auto end = std::back_inserter(text);
  int first = 1;  // number of the group's first vertex in the file
  for (const ObjGroup& group : groups) {
    fmt::format_to(end, "o {}\n", group.name);
    for (const Vector3& v : group.mesh.vertices) fmt::format_to(end, "v {} {} {}\n", v.x(), v.y(), v.z());
    for (const Eigen::Vector3i& t : group.mesh.triangles)
      fmt::format_to(end, "f {} {} {}\n", first + t[0], first + t[1], first + t[2]);
    first += static_cast<int>(group.mesh.vertices.size());
  }
  return text;
}

/// Parameters with which the mesh is read as the same ground.
std::string MeshParameters(const Terrain& terrain, std::vector<std::string>& notes) {
  std::string parameters = FrictionParameter(terrain, notes);
  double finest = 0.0;
  for (const HeightField& field : terrain.height_fields)
    finest = finest > 0.0 ? std::min(finest, field.resolution_m) : field.resolution_m;
  if (finest > 0.0) parameters += fmt::format("{}resolution_m={}", parameters.empty() ? "" : ",", finest);
  return parameters;
}

}  // namespace

Result<WrittenGround> WriteObj(const Terrain& terrain) {
  const auto refuse = [&](const std::string& why) {
    return Failure{FailureKind::kBadInput, FailureCode::kTerrainFile, "WriteObj", why, {}};
  };
  const Eigen::AlignedBox2d extent = ExtentOf(terrain, true);
  if (extent.isEmpty())
    return refuse(fmt::format("ground '{}' has no surfaces; there is nothing to write", terrain.name));
  std::vector<ObjGroup> groups = GroupsOf(terrain, extent);
  WrittenGround written;
  written.notes = NotesOfCutPlanes(terrain, extent);
  std::size_t points = 0, triangles = 0;
  for (const ObjGroup& group : groups) {
    points += group.mesh.vertices.size();
    triangles += group.mesh.triangles.size();
    if (group.mesh.triangles.empty())
      written.notes.push_back(fmt::format("obstacle '{}' is left out: it has no volume", group.name));
  }
  if (points > kMostMeshPoints || triangles > kMostMeshTriangles) {
    return refuse(
        fmt::format("ground '{}' has {} points and {} triangles; an OBJ file of at most {} and {} can be read "
                    "back. Write a .xml or .png file instead",
                    terrain.name, points, triangles, kMostMeshPoints, kMostMeshTriangles));
  }
  written.parameters = MeshParameters(terrain, written.notes);
  written.bytes = ObjText(terrain.name, groups);
  return written;
}

}  // namespace gaitwright
