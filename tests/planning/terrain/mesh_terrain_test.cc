// SPDX-License-Identifier: BSD-3-Clause
#include "planning/terrain/mesh_terrain.h"

#include <fmt/format.h>

#include <cmath>

#include "kinematics/spatial/convex_hull.h"
#include "planning/terrain/flat_pieces.h"
#include "tests/planning/terrain/terrain_files.h"

namespace gaitwright {
namespace {

using terrain_files::Loaded;
using terrain_files::ReasonRefused;
using terrain_files::Says;
using terrain_files::Written;

/// Adds a level or tilted rectangle of 2 * n * n triangles that face up.
void AddRectangle(Mesh& mesh, const Vector3& corner, const Vector3& along, const Vector3& across, int n = 1) {
  const auto first = static_cast<int>(mesh.vertices.size());
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= n; ++i) mesh.vertices.emplace_back(corner + along * i / n + across * j / n);
  }
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const int a = first + j * (n + 1) + i;
      mesh.triangles.emplace_back(a, a + 1, a + n + 2);
      mesh.triangles.emplace_back(a, a + n + 2, a + n + 1);
    }
  }
}

/// Each triangle has separate corners, as in STL.
std::string Stl(const Mesh& mesh) {
  std::string text = "solid s\n";
  for (const Eigen::Vector3i& t : mesh.triangles) {
    text += "facet normal 0 0 0\nouter loop\n";
    for (const int corner : {t[0], t[1], t[2]}) {
      const Vector3& v = mesh.vertices[static_cast<std::size_t>(corner)];
      text += fmt::format("vertex {} {} {}\n", v.x(), v.y(), v.z());
    }
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid s\n";
}

Mesh StairsMesh() {
  Mesh mesh;
  AddRectangle(mesh, {-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, 3);
  AddRectangle(mesh, {1, -1, 0.1}, {0.3, 0, 0}, {0, 2, 0}, 2);
  AddRectangle(mesh, {1.3, -1, 0.2}, {0.3, 0, 0.05}, {0, 2, 0});
  AddRectangle(mesh, {1, -1, 0}, {0, 2, 0}, {0, 0, 0.1});  // a riser
  return mesh;
}

TEST(MeshTerrain, FlatFacesBecomePatchesAndRisersNothing) {
  const Terrain terrain = Loaded(Written("stairs.stl", Stl(StairsMesh())));
  EXPECT_EQ(terrain.name, "stairs.stl");
  ASSERT_EQ(terrain.patches.size(), 3U);
  EXPECT_TRUE(terrain.height_fields.empty());
  EXPECT_EQ(terrain.patches[0].outline_T.size(), 4U) << "corners within its edges are no corners";
  EXPECT_NEAR(GroundAt(terrain, {0.0, 0.3}).height_m, 0.0, 1e-6);
  EXPECT_NEAR(GroundAt(terrain, {1.15, 0.3}).height_m, 0.1, 1e-6);
  EXPECT_NEAR(GroundAt(terrain, {1.45, 0.3}).height_m, 0.225, 1e-6);
  EXPECT_EQ(GroundAt(terrain, {1.7, 0.3}).patch, -1);
}

TEST(MeshTerrain, AFaceThatIsNotConvexFallsIntoConvexOnes) {
  Mesh mesh;  // an L, finely cut
  AddRectangle(mesh, {0, 0, 0}, {2, 0, 0}, {0, 1, 0}, 4);
  AddRectangle(mesh, {0, 1, 0}, {1, 0, 0}, {0, 1, 0}, 2);
  const std::vector<FlatPiece> pieces = FlatPieces(mesh, 0.7);
  EXPECT_GE(pieces.size(), 2U);
  EXPECT_LE(pieces.size(), 6U) << "and not into its triangles";
  double area = 0.0;
  std::size_t triangles = 0;
  for (const FlatPiece& piece : pieces) {
    std::vector<Vector2> outline;
    for (const Vector3& corner : piece.corners) outline.emplace_back(corner.head<2>());
    EXPECT_NEAR(ShareOfHull(outline), 1.0, 1e-9);
    area += Area(outline);
    triangles += piece.triangles.size();
  }
  EXPECT_NEAR(area, 3.0, 1e-9) << "nothing is lost, nothing covered twice";
  EXPECT_EQ(triangles, mesh.triangles.size());
  const Terrain terrain = *TerrainFromMesh(mesh, {}, "L");
  for (const Vector2& p : {Vector2(0.5, 1.5), Vector2(1.5, 0.5), Vector2(0.9, 0.9)})
    EXPECT_GE(GroundAt(terrain, p).patch, 0) << p.transpose();
  EXPECT_EQ(GroundAt(terrain, {1.1, 1.1}).patch, -1);
}

TEST(MeshTerrain, WhatIsNotFlatBecomesAHeightField) {
  const auto height = [](double x, double y) { return 0.05 * std::sin(5.0 * x) * std::cos(4.0 * y); };
  Mesh mesh;
  AddRectangle(mesh, {0, 0, 0}, {2, 0, 0}, {0, 1, 0}, 60);
  for (Vector3& v : mesh.vertices) v.z() = height(v.x(), v.y());
  MeshTerrainOptions options;
  options.least_m = 0.1;
  const Result<Terrain> terrain = TerrainFromMesh(mesh, options, "hills");
  ASSERT_TRUE(terrain.ok()) << terrain.failure().message;
  ASSERT_EQ(terrain->height_fields.size(), 1U);
  for (double x = 0.1; x < 1.9; x += 0.13) {
    for (double y = 0.1; y < 0.9; y += 0.11) EXPECT_NEAR(GroundAt(*terrain, {x, y}).height_m, height(x, y), 2e-3);
  }
}

TEST(MeshTerrain, FlatAndHillyStandTogether) {
  Mesh mesh = StairsMesh();
  AddRectangle(mesh, {2, -1, 0}, {1, 0, 0}, {0, 2, 0}, 40);
  for (Vector3& v : mesh.vertices) {
    if (v.x() >= 2.0) v.z() = 0.3 + 0.05 * std::sin(6.0 * v.x());
  }
  const Terrain terrain = *TerrainFromMesh(mesh, {}, "both");
  EXPECT_GE(terrain.patches.size(), 3U);
  ASSERT_EQ(terrain.height_fields.size(), 1U);
  EXPECT_GE(terrain.height_fields[0].origin_W.x(), 2.0 - 1e-9) << "only over what needs it";
  EXPECT_NEAR(GroundAt(terrain, {2.5, 0.0}).height_m, 0.3 + 0.05 * std::sin(15.0), 2e-3);
}

TEST(MeshTerrain, OptionsPlaceAndScaleIt) {
  Mesh mesh = StairsMesh();
  for (Vector3& v : mesh.vertices) v *= 1000.0;
  const std::string path = Written("mm.stl", Stl(mesh));
  EXPECT_TRUE(Says(ReasonRefused(path), "scale=0.001")) << "millimetres are noticed";
  const Terrain terrain = Loaded(path + ":scale=0.001,x_m=1,z_m=0.5,friction=0.4");
  EXPECT_NEAR(GroundAt(terrain, {2.15, 0.3}).height_m, 0.6, 1e-5);
  EXPECT_EQ(GroundAt(terrain, {2.15, 0.3}).friction, 0.4);
}

TEST(MeshTerrain, WrongFilesAreRefused) {
  Mesh upside;
  AddRectangle(upside, {0, 0, 0}, {0, 1, 0}, {1, 0, 0});
  EXPECT_TRUE(Says(ReasonRefused(Written("up.stl", Stl(upside))), "no face that points up"));
  EXPECT_TRUE(Says(ReasonRefused(Written("no.obj", "v 0 0 0\n")), "no.obj"));
  EXPECT_TRUE(Says(ReasonRefused(terrain_files::Folder() + "none.obj"), "does not exist"));
  EXPECT_TRUE(Says(ReasonRefused(Written("ok.stl", Stl(StairsMesh())) + ":scale=0"), "'scale' is 0"));
}

}  // namespace
}  // namespace gaitwright
