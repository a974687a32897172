// SPDX-License-Identifier: BSD-3-Clause
#include "planning/paths/foothold_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "tests/planning/paths/walled_grounds.h"

namespace gaitwright {
namespace {

using Kind = FootholdMap::Kind;

/// A robot with legs of 1 m and feet of 0.1 m: cells of 50 mm.
BodySpace MappedSpace() {
  BodySpace space;
  space.leg_length_m = 1.0;
  space.foot_radius_m = 0.1;
  space.max_slope_rad = 0.5;
  return space;
}

/// A map together with the objects to which it refers.
struct MadeMap {
  explicit MadeMap(Terrain ground, const BodySpace& space = MappedSpace())
      : terrain(std::move(ground)), obstacles(ShapesOf(terrain)), map(terrain, obstacles, space) {}
  MadeMap(const MadeMap&) = delete;

  static std::vector<Shape> ShapesOf(const Terrain& terrain) {
    std::vector<Shape> shapes;
    for (const Obstacle& obstacle : terrain.obstacles) shapes.push_back(ShapeOf(obstacle));
    return shapes;
  }
  Kind At(double x_m, double y_m) { return map.At({x_m, y_m}).kind; }

  Terrain terrain;
  ShapeScene obstacles;
  FootholdMap map;
};

Terrain TiltedGround(double slope, double friction = 0.8) {
  Terrain terrain = FlatTerrain(friction);
  terrain.patches[0].X_WT.linear() = Eigen::AngleAxisd(-std::atan(slope), Vector3::UnitY()).toRotationMatrix();
  return terrain;
}

TEST(FootholdMapCells, AreATwentiethOfTheLegAndLieOnAGridThroughTheOrigin) {
  MadeMap made(FlatTerrain());
  EXPECT_DOUBLE_EQ(made.map.resolution_m(), 0.05);
  const FootholdMap::Cell& cell = made.map.At({0.124, -0.26});
  EXPECT_EQ(&made.map.At({0.101, -0.24}), &cell) << "the same cell";
  EXPECT_NE(&made.map.At({0.126, -0.26}), &cell);
}

TEST(FootholdMapCells, OnLevelGroundAreAllFootholdsNearAndFar) {
  MadeMap made(FlatTerrain());
  for (const double x : {-100.0, -1.601, -1.599, 0.0, 1.61, 250.0}) {
    for (const double y : {-7.0, 0.0, 1.6}) {
      EXPECT_EQ(made.At(x, y), Kind::kFoothold) << x << ", " << y;
      EXPECT_EQ(made.map.At({x, y}).height_m, 0.0F);
    }
  }
}

TEST(FootholdMapCells, KnowTheHeightAndTheSlopeOfTheirGround) {
  MadeMap made(TiltedGround(0.2));
  for (const double x : {-1.0, 0.5, 2.0}) {
    const FootholdMap::Cell& cell = made.map.At({x, 0.3});
    EXPECT_EQ(cell.kind, Kind::kFoothold);
    EXPECT_NEAR(cell.height_m, 0.2 * x, 1e-5);
    EXPECT_NEAR(cell.by_x, 0.2, 1e-5);
    EXPECT_NEAR(cell.by_y, 0.0, 1e-5);
  }
}

TEST(FootholdMapCells, TooSteepIsSteeperThanTheLimitOrThanTheFriction) {
  const double limit = std::tan(0.5);
  EXPECT_EQ(MadeMap(TiltedGround(0.98 * limit)).At(0.5, 0.0), Kind::kFoothold);
  EXPECT_EQ(MadeMap(TiltedGround(1.02 * limit)).At(0.5, 0.0), Kind::kTooSteep);
  EXPECT_EQ(MadeMap(TiltedGround(0.29, 0.3)).At(0.5, 0.0), Kind::kFoothold);
  EXPECT_EQ(MadeMap(TiltedGround(0.31, 0.3)).At(0.5, 0.0), Kind::kTooSteep);
}

TEST(FootholdMapCells, AtAnEdgeHaveTooLittleGroundAndBeyondItNone) {
  Terrain terrain;
  terrain.patches = {Slab("slab", {-1.0, -1.0}, {1.0, 1.0}, 0.2)};
  MadeMap made(terrain);
  EXPECT_EQ(made.At(0.0, 0.0), Kind::kFoothold);
  EXPECT_EQ(made.At(0.85, 0.0), Kind::kFoothold);
  EXPECT_EQ(made.At(1.2, 0.0), Kind::kNoGround);
  EXPECT_EQ(made.At(0.0, -1.2), Kind::kNoGround);
  EXPECT_EQ(made.At(1.0, 1.0), Kind::kTooLittle) << "a quarter of the foot is on its corner";
}

TEST(FootholdMapCells, AStepIsNoGroundForBothOfItsHeightsAtOnce) {
  Terrain terrain = FlatTerrain();
  terrain.patches.push_back(Slab("curb", {0.5, -0.03}, {2.0, 0.03}, 0.2));
  MadeMap made(terrain);
  EXPECT_EQ(made.At(1.0, 0.0), Kind::kTooLittle) << "the curb is narrower than the foot";
  terrain.patches.back() = Slab("curb", {0.5, -0.5}, {2.0, 0.5}, 0.2);
  MadeMap wide(terrain);
  EXPECT_EQ(wide.At(1.0, 0.0), Kind::kFoothold);
  EXPECT_NEAR(wide.map.At({1.0, 0.0}).height_m, 0.2, 1e-6);
}

TEST(FootholdMapCells, UnderAnObstacleThereIsNoFoothold) {
  MadeMap made(Walled({Wall("wall", {1.0, -1.0}, {1.0, 1.0}, 0.2)}));
  EXPECT_EQ(made.At(1.0, 0.0), Kind::kTooLittle);
  EXPECT_EQ(made.At(1.14, 0.0), Kind::kTooLittle) << "the foot touches it";
  EXPECT_EQ(made.At(1.3, 0.0), Kind::kFoothold);
}

TEST(FootholdMapCells, DoNotDependOnTheOrderOfQuestionsNorOnWhereTheGroundIs) {
  Terrain terrain = FlatTerrain();
  terrain.patches = {Slab("a", {-0.92, -0.72}, {0.62, 0.42}), Slab("b", {0.62, -0.22}, {1.52, 0.92}, 0.1)};
  Terrain moved = terrain;
  for (TerrainPatch& patch : moved.patches) patch.X_WT.translation() += Vector3(-3.2, 4.8, 0.0);  // two tiles, three
  MadeMap here(terrain), again(terrain), there(moved);
  std::vector<Vector2> places;
  for (int i = -24; i < 36; i += 3) {
    for (int j = -20; j < 24; j += 3) places.emplace_back(0.05 * i, 0.05 * j);  // the middles of cells
  }
  for (const Vector2& p : places) (void)here.At(p.x(), p.y());
  std::reverse(places.begin(), places.end());
  for (const Vector2& p : places) {
    EXPECT_EQ(again.At(p.x(), p.y()), here.At(p.x(), p.y())) << p.transpose();
    EXPECT_EQ(there.At(p.x() - 3.2, p.y() + 4.8), here.At(p.x(), p.y())) << p.transpose();
  }
}

}  // namespace
}  // namespace gaitwright
