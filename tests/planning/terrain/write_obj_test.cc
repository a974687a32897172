// SPDX-License-Identifier: BSD-3-Clause
#include "planning/terrain/write_obj.h"

#include <algorithm>
#include <map>
#include <numbers>
#include <sstream>
#include <utility>

#include "kinematics/model/mesh_parts.h"
#include "planning/terrain/mesh_terrain.h"
#include "tests/planning/terrain/terrain_files.h"
#include "tests/planning/terrain/written_terrain.h"

namespace gaitwright {
namespace {

using written_terrain::BuiltIn;
using written_terrain::Hills;
using written_terrain::IsNearObstacle;
using written_terrain::PlacesOn;
using written_terrain::Rectangle;

WrittenGround WrittenObj(const Terrain& terrain) {
  const Result<WrittenGround> written = WriteObj(terrain);
  EXPECT_TRUE(written.ok()) << written.failure().message;
  return written.ok() ? *written : WrittenGround{};
}

Terrain MeshReadBack(const Terrain& terrain, const MeshTerrainOptions& options = {}) {
  const Result<Terrain> read = TerrainFromMesh(ParseObj(WrittenObj(terrain).bytes), options, "written");
  EXPECT_TRUE(read.ok()) << read.failure().message;
  return read.ok() ? *read : Terrain{};
}

std::vector<std::string> GroupNames(const std::string& obj) {
  std::vector<std::string> names;
  std::istringstream text(obj);
  for (std::string line; std::getline(text, line);) {
    if (line.starts_with("o ")) names.push_back(line.substr(2));
  }
  return names;
}

/// The volume of a mesh whose surface is closed.
double VolumeOfClosed(const Mesh& mesh) {
  double six = 0.0;
  std::map<std::pair<int, int>, int> edges;
  for (const Eigen::Vector3i& t : mesh.triangles) {
    const auto at = [&](int i) -> const Vector3& { return mesh.vertices[static_cast<std::size_t>(t[i])]; };
    six += at(0).dot(at(1).cross(at(2)));
    for (int i = 0; i < 3; ++i) ++edges[{t[i], t[(i + 1) % 3]}];
  }
  for (const auto& [edge, count] : edges) EXPECT_EQ(count, (edges[{edge.second, edge.first}])) << "an open edge";
  return six / 6.0;
}

// Places near obstacles are left out, because obstacles become ground in a mesh.
TEST(WriteObj, EveryBuiltInGroundIsReadBackWithItsHeights) {
  for (const BuiltInTerrain& entry : BuiltInTerrains()) {
    SCOPED_TRACE(entry.name);
    const Terrain terrain = BuiltIn(entry.name), read = MeshReadBack(terrain);
    // Deviations of 1 mm or less count as flat in a mesh.
    const double accepted = terrain.height_fields.empty() ? 1e-6 : 2e-3;
    int compared = 0;
    for (const Vector2& p : PlacesOn(terrain, 1000)) {
      const GroundPoint ground = GroundAt(terrain, p);
      if (ground.patch < 0 || IsNearObstacle(terrain, p, 0.05)) continue;
      ++compared;
      ASSERT_GE(GroundAt(read, p).patch, 0) << p.transpose();
      ASSERT_NEAR(GroundAt(read, p).height_m, ground.height_m, accepted) << p.transpose();
    }
    EXPECT_GT(compared, 100);
  }
}

TEST(WriteObj, AHeightFieldIsReadBackExactlyAtItsOwnResolution) {
  Terrain terrain;
  terrain.height_fields = {Hills({0.31, -0.4}, 0.05, 23, 17)};
  EXPECT_EQ(WrittenObj(terrain).parameters, "resolution_m=0.05");
  MeshTerrainOptions options;
  options.resolution_m = 0.05;
  options.least_m = 10.0;
  const Terrain read = MeshReadBack(terrain, options);
  ASSERT_EQ(read.height_fields.size(), 1U);
  for (const Vector2& p : PlacesOn(terrain, 1000))
    ASSERT_NEAR(GroundAt(read, p).height_m, GroundAt(terrain, p).height_m, 1e-6) << "another diagonal";
  EXPECT_EQ(ParseObj(WrittenObj(terrain).bytes).triangles.size(), 2U * 22U * 16U);
}

TEST(WriteObj, PatchesAndObstaclesAreClosedSolids) {
  Terrain ramp;
  ramp.patches = {PatchThrough("ramp", {{0, 0, 0}, {2, 0, 0.5}, {2, 1, 0.5}, {0, 1, 0}}, 0.8)};
  EXPECT_NEAR(VolumeOfClosed(ParseObj(WrittenObj(ramp).bytes)), 2.0 * kSolidDepth, 1e-9);
  const auto with = [&](Obstacle obstacle) {
    obstacle.X_WO = Eigen::Translation3d(5.0, 1.0, 2.0) * Eigen::AngleAxisd(0.4, Vector3::UnitY());
    Terrain terrain = ramp;
    terrain.obstacles = {std::move(obstacle)};
    return VolumeOfClosed(ParseObj(WrittenObj(terrain).bytes)) - 2.0 * kSolidDepth;
  };
  EXPECT_NEAR(with({"box", ShapeType::kBox, Pose::Identity(), {1.0, 2.0, 0.5}, {}}), 1.0, 1e-9);
  const double circle = 16.0 * std::sin(std::numbers::pi / 16.0);  // 32 sides, in the unit circle
  EXPECT_NEAR(with({"post", ShapeType::kCylinder, Pose::Identity(), {0.5, 2.0, 0.0}, {}}), 0.5 * circle, 1e-9);
  const std::vector<Vector3> corners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.1, 0.1, 0.1}};
  EXPECT_NEAR(with({"rock", ShapeType::kMesh, Pose::Identity(), Vector3::Zero(), corners}), 1.0 / 6.0, 1e-9);
}

TEST(WriteObj, AnObstacleIsGroundWhenItIsReadBack) {
  Terrain terrain = FlatTerrain();
  Obstacle wall;
  wall.size_m = Vector3(1.0, 0.4, 0.6);
  wall.X_WO.translation() = Vector3(7.0, 0.0, 0.3);
  terrain.obstacles = {wall};
  const Terrain read = MeshReadBack(terrain);
  EXPECT_NEAR(GroundAt(read, {7.1, 0.1}).height_m, 0.6, 1e-6);
  EXPECT_NEAR(GroundAt(read, {6.0, 0.1}).height_m, 0.0, 1e-6) << "the surface without end goes on to the wall";
  EXPECT_EQ(GroundAt(read, {7.6, 0.1}).patch, -1);
}

TEST(WriteObj, AnInfiniteSurfaceIsCutAndThatIsSaid) {
  const WrittenGround written = WrittenObj(FlatTerrain(0.6));
  ASSERT_EQ(written.notes.size(), 1U);
  EXPECT_TRUE(terrain_files::Says(written.notes[0], "'ground' is cut to x from -5 to 5 m and y from -5 to 5 m"));
  EXPECT_EQ(written.parameters, "friction=0.6");
  const Terrain read = MeshReadBack(FlatTerrain());
  EXPECT_EQ(GroundAt(read, {4.999, -4.999}).patch, 0);
  EXPECT_EQ(GroundAt(read, {5.001, 0.0}).patch, -1);
  EXPECT_TRUE(WrittenObj(BuiltIn("gap")).notes.empty()) << "its surfaces have edges";
}

TEST(WriteObj, GroupsHaveNamesOfOneWordEach) {
  Terrain terrain;
  terrain.name = "a yard\nv 1 2 3";
  terrain.patches = {Rectangle("stone 1", {0, 0}, {1, 1}, 0.0, 0.5), Rectangle("stone\n1", {2, 0}, {3, 1}, 0.0),
                     Rectangle("", {4, 0}, {5, 1}, 0.0)};
  const WrittenGround written = WrittenObj(terrain);
  EXPECT_EQ(GroupNames(written.bytes), (std::vector<std::string>{"stone_1", "stone_1_2", "ground"}));
  EXPECT_EQ(ParseObj(written.bytes).vertices.size(), 24U);
  EXPECT_EQ(written.parameters, "friction=0.5") << "the lowest";
  ASSERT_EQ(written.notes.size(), 1U);
  EXPECT_TRUE(terrain_files::Says(written.notes[0], "from 0.5 to 0.8"));
}

TEST(WriteObj, RefusesWhatCannotBeReadBack) {
  EXPECT_TRUE(terrain_files::Says(WriteObj({}).failure().message, "no surfaces"));
  Terrain large;
  large.height_fields = {Hills({0, 0}, 0.02, 1100, 1100)};
  EXPECT_TRUE(terrain_files::Says(WriteObj(large).failure().message, "2415602 triangles"));
  Terrain flat = FlatTerrain();
  flat.obstacles = {
      {"plate", ShapeType::kMesh, Pose::Identity(), Vector3::Zero(), {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}}};
  EXPECT_TRUE(terrain_files::Says(WrittenObj(flat).notes.back(), "'plate' is left out"));
}

}  // namespace
}  // namespace gaitwright
