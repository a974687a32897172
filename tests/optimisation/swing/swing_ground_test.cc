// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/swing/swing_ground.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "kinematics/base/non_finite.h"

namespace gaitwright {
namespace {

Obstacle BlockAt(const Vector3& middle_W, const Vector3& size_m) {
  Obstacle block;
  block.name = "block";
  block.X_WO.translation() = middle_W;
  block.size_m = size_m;
  return block;
}

TEST(HeightsOf, OfABoxAreItsFacesWithinItsOutline) {
  const Obstacle box = BlockAt({1.0, 2.0, 0.5}, {0.4, 0.2, 0.6});
  for (const Vector2& p : {Vector2(1.0, 2.0), Vector2(1.19, 2.09), Vector2(0.81, 1.91)}) {
    const auto heights = HeightsOf(box, p);
    ASSERT_TRUE(heights) << p.transpose();
    EXPECT_NEAR(heights->first, 0.2, 1e-12);
    EXPECT_NEAR(heights->second, 0.8, 1e-12);
  }
  for (const Vector2& p : {Vector2(1.21, 2.0), Vector2(0.79, 2.0), Vector2(1.0, 2.11), Vector2(1.0, 1.89)})
    EXPECT_FALSE(HeightsOf(box, p)) << p.transpose();
}

TEST(HeightsOf, OfABoxOnItsEdgeGrowTowardsItsMiddle) {
  Obstacle box = BlockAt({0.0, 0.0, 1.0}, {0.2, 0.4, 0.2});
  box.X_WO.linear() = Eigen::AngleAxisd(std::numbers::pi / 4.0, Vector3::UnitY()).toRotationMatrix();
  const double half = 0.1 * std::sqrt(2.0);
  for (const double x : {0.0, 0.05, -0.1}) {
    const auto heights = HeightsOf(box, {x, 0.15});
    ASSERT_TRUE(heights);
    EXPECT_NEAR(heights->second, 1.0 + half - std::abs(x), 1e-9);
    EXPECT_NEAR(heights->first, 1.0 - half + std::abs(x), 1e-9);
  }
  EXPECT_FALSE(HeightsOf(box, {half + 1e-3, 0.0}));
  EXPECT_FALSE(HeightsOf(box, {0.0, 0.201}));
}

TEST(HeightsOf, ACylinderIsTheBoxAboutIt) {
  Obstacle post = BlockAt({0.0, 0.0, 0.3}, {0.1, 0.6, 0.0});  // radius, length
  post.type = ShapeType::kCylinder;
  const auto heights = HeightsOf(post, {0.09, -0.09});
  ASSERT_TRUE(heights) << "a corner of the box";
  EXPECT_NEAR(heights->first, 0.0, 1e-12);
  EXPECT_NEAR(heights->second, 0.6, 1e-12);
  EXPECT_FALSE(HeightsOf(post, {0.11, 0.0}));
}

TEST(HeightsOf, AMeshIsTheBoxAboutItsVerticesThoughItsOriginIsElsewhere) {
  Obstacle mesh = BlockAt({1.0, 0.0, 0.0}, Vector3::Zero());
  mesh.type = ShapeType::kMesh;
  mesh.vertices_O = {{0.1, 0.2, 0.3}, {0.5, 0.2, 0.3}, {0.1, 0.6, 0.3}, {0.1, 0.2, 0.9}};
  const auto heights = HeightsOf(mesh, {1.3, 0.4});
  ASSERT_TRUE(heights);
  EXPECT_NEAR(heights->first, 0.3, 1e-12);
  EXPECT_NEAR(heights->second, 0.9, 1e-12);
  EXPECT_FALSE(HeightsOf(mesh, {1.0, 0.0})) << "its origin is outside of it";
}

TEST(HeightToClear, IsTheGroundOrTheObstacleOnIt) {
  Terrain terrain = FlatTerrain();
  EXPECT_EQ(HeightToClear(terrain, {0.0, 0.0}, 1.0), 0.0);
  terrain.obstacles = {BlockAt({0.0, 0.0, 0.05}, {0.2, 0.2, 0.1}), BlockAt({0.0, 0.0, 0.1}, {0.1, 0.1, 0.2})};
  EXPECT_NEAR(HeightToClear(terrain, {0.0, 0.0}, 1.0), 0.2, 1e-12) << "the higher of two";
  EXPECT_NEAR(HeightToClear(terrain, {0.08, 0.0}, 1.0), 0.1, 1e-12);
  EXPECT_EQ(HeightToClear(terrain, {0.3, 0.0}, 1.0), 0.0);
}

TEST(HeightToClear, ALintelAboveTheFootIsNone) {
  Terrain terrain = FlatTerrain();
  terrain.obstacles = {BlockAt({0.0, 0.0, 0.75}, {1.0, 1.0, 0.5})};  // from 0.5 to 1 m
  EXPECT_EQ(HeightToClear(terrain, {0.0, 0.0}, 0.49), 0.0);
  EXPECT_NEAR(HeightToClear(terrain, {0.0, 0.0}, 0.51), 1.0, 1e-12);
}

TEST(HeightToClear, WithoutGroundThereIsNothingToClear) {
  Terrain terrain;
  EXPECT_EQ(HeightToClear(terrain, {0.0, 0.0}, 1.0), -kInfinity);
  terrain.obstacles = {BlockAt({0.0, 0.0, 0.0}, {0.2, 0.2, 0.1})};
  EXPECT_NEAR(HeightToClear(terrain, {0.0, 0.0}, 1.0), 0.05, 1e-12);
}

}  // namespace
}  // namespace gaitwright
