// SPDX-License-Identifier: BSD-3-Clause
#include "planning/plan/terrain.h"

#include <gtest/gtest.h>

#include <random>

#include "kinematics/base/result.h"

namespace gaitwright {
namespace {

const std::vector<Vector3> kTilted = {{1.0, 0.0, 0.1}, {2.0, 0.0, 0.3}, {2.0, 1.0, 0.2}, {1.0, 1.0, 0.0}};

std::string ReasonTerrainRefused(const std::vector<Vector3>& corners) {
  try {
    PatchThrough("top", corners, 0.5);
  } catch (const InvalidArgument& error) {
    return error.what();
  }
  return "";
}

TEST(PatchThrough, PassesThroughItsCorners) {
  const TerrainPatch patch = PatchThrough("top", kTilted, 0.5);
  Terrain terrain{"", {patch}, {}, {}};
  ASSERT_EQ(patch.outline_T.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    const Vector3 p_W = patch.X_WT * Vector3(patch.outline_T[i].x(), patch.outline_T[i].y(), 0.0);
    EXPECT_LT((p_W - kTilted[i]).norm(), 1e-12);
    const GroundPoint corner = GroundAt(terrain, kTilted[i].head<2>());
    EXPECT_EQ(corner.patch, 0) << "corners belong to it";
    EXPECT_NEAR(corner.height_m, kTilted[i].z(), 1e-12);
  }
  EXPECT_NEAR(patch.X_WT.linear().determinant(), 1.0, 1e-12);
  EXPECT_NEAR(GroundAt(terrain, {1.5, 0.5}).height_m, 0.15, 1e-12);
  EXPECT_NEAR(patch.X_WT.linear()(1, 0), 0.0, 1e-12) << "x of T lies along x of W in plan view";
}

TEST(PatchThrough, RefusesWhatIsNoConvexPiecePlane) {
  std::vector<Vector3> corners = kTilted;
  corners[2].z() += 0.01;
  EXPECT_NE(ReasonTerrainRefused(corners).find("not flat"), std::string::npos);
  corners = {kTilted.rbegin(), kTilted.rend()};
  EXPECT_NE(ReasonTerrainRefused(corners).find("counter-clockwise"), std::string::npos);
  corners = kTilted;
  corners[2] = {1.2, 0.2, 0.12};
  EXPECT_NE(ReasonTerrainRefused(corners).find("convex"), std::string::npos);
  EXPECT_NE(ReasonTerrainRefused({{0, 0, 0}, {1, 0, 0}}).find("2 corners"), std::string::npos);
}

/// A height field with the heights of a plane.
HeightField PlaneField(const Vector3& slope_and_height) {
  HeightField field{"field", {-0.3, 0.2}, 0.05, 9, 7, {}, 0.6};
  for (int row = 0; row < field.rows; ++row) {
    for (int column = 0; column < field.columns; ++column) {
      const Vector2 p = field.origin_W + field.resolution_m * Vector2(column, row);
      field.height_m.push_back(slope_and_height.dot(Vector3(p.x(), p.y(), 1.0)));
    }
  }
  return field;
}

TEST(GroundAt, AFieldOfAPlaneIsThePlane) {
  const Vector3 plane(0.3, -0.2, 0.1);
  const Terrain terrain{"", {}, {PlaneField(plane)}, {}};
  const Vector3 normal = Vector3(-0.3, 0.2, 1.0).normalized();
  std::mt19937 engine(1);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  for (int i = 0; i < 200; ++i) {
    const Vector2 p(-0.3 + 0.4 * share(engine), 0.2 + 0.3 * share(engine));
    const GroundPoint ground = GroundAt(terrain, p);
    ASSERT_EQ(ground.patch, 0);
    EXPECT_NEAR(ground.height_m, plane.dot(Vector3(p.x(), p.y(), 1.0)), 1e-12);
    EXPECT_LT((ground.normal_W - normal).norm(), 1e-12);
    EXPECT_EQ(ground.friction, 0.6);
  }
  EXPECT_EQ(GroundAt(terrain, {-0.31, 0.3}).patch, -1);
  EXPECT_EQ(GroundAt(terrain, {0.0, 0.51}).patch, -1);
}

TEST(GroundAt, TheHighestSurfaceHoldsAndIsNumberedAfterThePatches) {
  Terrain terrain = FlatTerrain(0.9);
  terrain.patches.push_back(PatchThrough("top", kTilted, 0.5));
  HeightField field = PlaneField({0.0, 0.0, 0.05});
  field.origin_W = {1.0, 0.0};
  terrain.height_fields.push_back(field);
  EXPECT_EQ(terrain.num_surfaces(), 3);
  EXPECT_EQ(GroundAt(terrain, {0.5, 0.1}).patch, 0);
  EXPECT_EQ(GroundAt(terrain, {1.3, 0.05}).patch, 1);
  EXPECT_EQ(GroundAt(terrain, {1.02, 0.9}).patch, 1);
  EXPECT_EQ(GroundAt(terrain, {1.02, 0.29}).patch, 1);
  terrain.patches.pop_back();
  EXPECT_EQ(GroundAt(terrain, {1.3, 0.05}).patch, 1);
  EXPECT_EQ(GroundAt(terrain, {1.3, 0.05}).friction, 0.6);
}

TEST(KindOfGround, IsTheSimplestThatHolds) {
  EXPECT_EQ(KindOfGround(FlatTerrain()), GroundKind::kFlat);
  Terrain level = FlatTerrain();
  level.patches.front().X_WT.translation().z() = 0.1;
  EXPECT_EQ(KindOfGround(level), GroundKind::kLevel);
  Terrain bounded = FlatTerrain();
  bounded.patches.front().outline_T = {Vector2(1, 1), Vector2(-1, 1), Vector2(-1, -1), Vector2(1, -1)};
  EXPECT_EQ(KindOfGround(bounded), GroundKind::kBounded);
  Terrain tilted = FlatTerrain();
  tilted.patches.front().X_WT.linear() = Eigen::AngleAxisd(1e-3, Vector3::UnitY()).toRotationMatrix();
  EXPECT_EQ(KindOfGround(tilted), GroundKind::kUneven);
  Terrain walled = FlatTerrain();
  walled.obstacles.push_back({"wall", ShapeType::kBox, Pose::Identity(), Vector3(1, 0.1, 1), {}});
  EXPECT_EQ(KindOfGround(walled), GroundKind::kUneven);
  Terrain two = bounded;
  two.patches.push_back(bounded.patches.front());
  EXPECT_EQ(KindOfGround(two), GroundKind::kUneven);
}

}  // namespace
}  // namespace gaitwright
