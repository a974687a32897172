// SPDX-License-Identifier: BSD-3-Clause
#include "planning/footsteps/ground_index.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "kinematics/base/non_finite.h"
#include "kinematics/stability/polygon.h"
#include "tests/planning/footsteps/grounds.h"

namespace gaitwright {
namespace {

/// Infinite level ground, a platform on it, stones beyond the platform, and a height field.
Terrain MixedGround() {
  Terrain terrain = FlatTerrain();
  terrain.patches.push_back(Rectangle("platform", {1.0, -0.5}, {2.0, 0.5}, 0.2));
  terrain.patches.push_back(Rectangle("ramp", {2.0, -0.5}, {3.0, 0.5}, 0.2, 0.3));
  HeightField field;
  field.name = "field";
  field.origin_W = Vector2(-2.0, -1.0);
  field.resolution_m = 0.25;
  field.columns = field.rows = 5;
  for (int k = 0; k < 25; ++k) field.height_m.push_back(0.05 + 0.01 * (k % 7));
  terrain.height_fields = {field};
  Obstacle post;
  post.name = "post";
  post.X_WO.translation() = Vector3(0.5, 1.0, 0.4);
  post.size_m = Vector3(0.2, 0.1, 0.6);
  terrain.obstacles = {post};
  return terrain;
}

std::vector<int> IndexedPatches(const GroundIndex& ground, const Vector2& low, const Vector2& high) {
  std::vector<int> found;
  ground.PatchesIn(low, high, found);
  return found;
}

TEST(GroundIndexAt, IsTheTerrainsOwnAnswerWhateverTheCells) {
  const Terrain terrain = MixedGround();
  std::mt19937 random(4);
  std::uniform_real_distribution<double> x(-3.0, 4.0), y(-2.0, 2.0);
  for (const double cell_m : {0.05, 0.3, 10.0}) {
    const GroundIndex ground(terrain, cell_m);
    for (int k = 0; k < 500; ++k) {
      const Vector2 p(x(random), y(random));
      const GroundPoint expected = GroundAt(terrain, p), found = ground.At(p);
      ASSERT_EQ(found.patch, expected.patch) << p.transpose();
      EXPECT_NEAR(found.height_m, expected.height_m, 1e-12);
      EXPECT_LT((found.normal_W - expected.normal_W).norm(), 1e-12);
      EXPECT_EQ(found.friction, expected.friction);
    }
  }
}

TEST(GroundIndexAt, WithoutGroundThereIsNone) {
  Terrain terrain;
  terrain.patches = {Rectangle("slab", {0.0, 0.0}, {1.0, 1.0}, 0.0)};
  const GroundIndex ground(terrain, 0.1);
  EXPECT_EQ(ground.At({0.5, 0.5}).patch, 0);
  EXPECT_EQ(ground.At({1.5, 0.5}).patch, -1);
  EXPECT_EQ(ground.At({-9.0, 99.0}).patch, -1);
  const Terrain nothing;
  EXPECT_EQ(GroundIndex(nothing, 0.1).At({0.0, 0.0}).patch, -1);
}

TEST(GroundIndexPatches, AreAllThatMeetTheBoxEachOnceAndInOrder) {
  const Terrain terrain = Stones(0.5, 3.0, 0.12, 0.2, 0.02, 1.0, 0.02, 5);
  const GroundIndex ground(terrain, 0.15);
  std::mt19937 random(8);
  std::uniform_real_distribution<double> x(-0.5, 3.5), y(-0.8, 0.8), size(0.0, 0.5);
  for (int trial = 0; trial < 100; ++trial) {
    const Vector2 low(x(random), y(random)), high = low + Vector2(size(random), size(random));
    const std::vector<int> found = IndexedPatches(ground, low, high);
    EXPECT_TRUE(std::is_sorted(found.begin(), found.end()));
    EXPECT_EQ(std::adjacent_find(found.begin(), found.end()), found.end());
    for (std::size_t i = 0; i < ground.surfaces().size(); ++i) {
      const GroundSurface& surface = ground.surfaces()[i];
      const bool meets = surface.outline_W.empty() || ((surface.lowest_W.array() <= high.array()).all() &&
                                                       (surface.highest_W.array() >= low.array()).all());
      EXPECT_TRUE(!meets || std::binary_search(found.begin(), found.end(), static_cast<int>(i))) << i;
    }
  }
}

TEST(GroundIndexObstacles, AreFoundWhereTheirOutlineIs) {
  const Terrain terrain = MixedGround();
  const GroundIndex ground(terrain, 0.1);
  std::vector<int> found = {7};
  ground.ObstaclesIn({0.45, 0.9}, {0.55, 1.1}, found);
  EXPECT_EQ(found, std::vector<int>{0}) << "what was there before is replaced";
  ground.ObstaclesIn({-1.0, -1.0}, {-0.5, -0.5}, found);
  EXPECT_TRUE(found.empty());
  const ObstacleOutline& post = ground.obstacles()[0];
  EXPECT_NEAR(post.bottom_m, 0.1, 1e-12);
  EXPECT_NEAR(post.top_m, 0.7, 1e-12);
  EXPECT_NEAR(Area(post.outline_W), 0.02, 1e-12);
}

TEST(GroundIndexObstacles, APostIsHeldByAPrismAroundIt) {
  Terrain terrain = FlatTerrain();
  Obstacle post;
  post.type = ShapeType::kCylinder;
  post.size_m = Vector3(0.1, 1.0, 0.0);
  post.X_WO.translation() = Vector3(1.0, 2.0, 0.5);
  terrain.obstacles = {post};
  const GroundIndex ground(terrain, 0.1);
  const Polygon& outline = ground.obstacles()[0].outline_W;
  for (int k = 0; k < 64; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / 64;
    EXPECT_GE(SignedDistance(outline, Vector2(1.0 + 0.1 * std::cos(angle), 2.0 + 0.1 * std::sin(angle))), -1e-12);
  }
  EXPECT_LT(Area(outline), 1.03 * std::numbers::pi * 0.01) << "and hardly more";
}

TEST(GroundIndexHighest, IsNoLowerThanAnyGroundInTheBox) {
  const Terrain terrain = MixedGround();
  const GroundIndex ground(terrain, 0.2);
  std::mt19937 random(15);
  std::uniform_real_distribution<double> x(-3.0, 4.0), y(-2.0, 2.0), size(0.0, 0.6), share(0.0, 1.0);
  for (int trial = 0; trial < 100; ++trial) {
    const Vector2 low(x(random), y(random)), span(size(random), size(random));
    const double highest = ground.HighestIn(low, low + span);
    for (int k = 0; k < 20; ++k) {
      const Vector2 p = low + span.cwiseProduct(Vector2(share(random), share(random)));
      EXPECT_GE(highest, ground.At(p).height_m - 1e-12);
    }
  }
  EXPECT_NEAR(ground.HighestIn({-9.0, -9.0}, {-8.0, -8.0}), 0.0, 1e-12) << "the plane without end";
  const Terrain nothing;
  EXPECT_EQ(GroundIndex(nothing, 0.2).HighestIn({0.0, 0.0}, {1.0, 1.0}), -kInfinity);
}

TEST(GroundSurfaceInside, IsTheDistanceToTheNearestEdge) {
  Terrain terrain;
  terrain.patches = {Rectangle("slab", {0.0, 0.0}, {2.0, 1.0}, 0.0), FlatTerrain().patches[0]};
  const GroundIndex ground(terrain, 0.2);
  const GroundSurface &slab = ground.surfaces()[0], &endless = ground.surfaces()[1];
  EXPECT_NEAR(slab.Inside({1.0, 0.3}), 0.3, 1e-12);
  EXPECT_NEAR(slab.Inside({1.9, 0.5}), 0.1, 1e-12);
  EXPECT_NEAR(slab.Inside({2.1, 0.5}), -0.1, 1e-12);
  EXPECT_EQ(endless.Inside({5.0, 5.0}), kInfinity);
}

TEST(GroundSurfaceBeyond, TellsWhetherTheGroundFallsGoesOnOrRises) {
  using Beyond = GroundSurface::Beyond;
  Terrain terrain;
  terrain.patches = {Rectangle("middle", {0.0, 0.0}, {1.0, 1.0}, 0.0), Rectangle("ahead", {1.0, 0.0}, {2.0, 1.0}, 0.0),
                     Rectangle("left", {0.0, 1.0}, {1.0, 2.0}, 0.1),
                     Rectangle("behind", {-1.0, 0.0}, {0.0, 1.0}, -0.1)};
  const GroundIndex ground(terrain, 0.2);
  const GroundSurface& middle = ground.surfaces()[0];
  ASSERT_EQ(middle.beyond.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    const Vector2& inward = middle.inward[i];
    const Beyond expected = inward.x() < -0.5   ? Beyond::kSame    // the front edge
                            : inward.y() < -0.5 ? Beyond::kHigher  // on the left
                                                : Beyond::kLower;  // behind, and on the right, where there is no ground
    EXPECT_EQ(middle.beyond[i], expected) << i;
  }
}

}  // namespace
}  // namespace gaitwright
