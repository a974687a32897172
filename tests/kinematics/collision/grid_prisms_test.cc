// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "kinematics/base/result.h"
#include "kinematics/collision/fcl_shape_internal.h"
#include "kinematics/collision/grid_prisms_internal.h"

namespace gaitwright {
namespace {

/// A grid of 5 by 4 nodes, 0.5 m apart, starting at (-1, -0.75). A function of the position gives its heights.
template <class Height>
GridSolid GridOf(const Height& height) {
  GridSolid grid;
  grid.name = "hill";
  grid.columns = 5;
  grid.rows = 4;
  grid.resolution_m = 0.5;
  grid.origin_W = Vector2(-1.0, -0.75);
  grid.depth_m = 1.0;
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column)
      grid.height_m.push_back(height(-1.0 + 0.5 * column, -0.75 + 0.5 * row));
  }
  return grid;
}

fcl::CollisionObjectd PlacedShape(ShapeType type, const Vector3& size, const Vector3& p_W) {
  Shape shape;
  shape.type = type;
  shape.size = size;
  Pose X = Pose::Identity();
  X.translation() = p_W;
  fcl::CollisionObjectd object(FclGeometry(shape), X);
  object.computeAABB();
  return object;
}

fcl::CollisionObjectd BallAt(double radius, const Vector3& p_W) {
  return PlacedShape(ShapeType::kSphere, {radius, 0.0, 0.0}, p_W);
}

TEST(GridPrisms, OverLevelGroundTheDistanceIsTheHeight) {
  const GridPrisms level(GridOf([](double, double) { return 0.2; }));
  for (const Vector2& p : {Vector2(0.0, 0.0), Vector2(0.1, -0.3), Vector2(-0.9, 0.7), Vector2(0.25, 0.25)}) {
    for (const double height : {0.05, 0.3, 0.7})
      EXPECT_NEAR(level.Distance(BallAt(0.1, {p.x(), p.y(), 0.3 + height}), 1.0, false), height, 1e-5) << p.transpose();
    EXPECT_NEAR(level.Distance(BallAt(0.1, {p.x(), p.y(), 0.28}), 1.0, false), -0.02, 1e-3) << p.transpose();
  }
}

TEST(GridPrisms, OverASlopeTheDistanceIsThatToThePlane) {
  const double slope = 0.5;
  const GridPrisms ramp(GridOf([&](double x, double) { return slope * x; }));
  for (const double x : {-0.3, 0.0, 0.2}) {
    const Vector3 p(x, 0.05, slope * x + 0.3);
    EXPECT_NEAR(ramp.Distance(BallAt(0.1, p), 1.0, false), 0.3 / std::hypot(1.0, slope) - 0.1, 1e-5) << x;
  }
}

TEST(GridPrisms, BeyondItsEdgeTheDistanceIsThatToTheEdge) {
  const GridPrisms level(GridOf([](double, double) { return 0.0; }));
  EXPECT_NEAR(level.Distance(BallAt(0.1, {1.5, 0.0, -0.2}), 1.0, false), 0.4, 1e-5);
  EXPECT_NEAR(level.Distance(BallAt(0.1, {1.3, 0.0, 0.4}), 1.0, false), 0.4, 1e-5) << "3, 4, 5";
  EXPECT_NEAR(level.Distance(BallAt(0.1, {0.0, -1.25, -0.3}), 1.0, false), 0.4, 1e-5);
}

TEST(GridPrisms, WhatIsNotNearerThanAskedForIsThat) {
  const GridPrisms level(GridOf([](double, double) { return 0.0; }));
  const auto ball = BallAt(0.1, {0.0, 0.0, 0.5});
  EXPECT_EQ(level.Distance(ball, 0.3, false), 0.3);
  EXPECT_NEAR(level.Distance(ball, 0.5, false), 0.4, 1e-5);
  EXPECT_EQ(level.Distance(BallAt(0.1, {50.0, 0.0, 0.0}), 0.3, false), 0.3);
  EXPECT_EQ(level.Distance(ball, 0.0, true), 0.0) << "no touch";
}

TEST(GridPrisms, APeakBetweenLowNodesIsFound) {
  const GridPrisms peak(GridOf([](double x, double y) { return x == 0.0 && y == 0.25 ? 0.6 : 0.0; }));
  EXPECT_NEAR(peak.Distance(BallAt(0.1, {0.0, 0.25, 1.0}), 1.0, false), 0.3, 1e-5);
  EXPECT_NEAR(peak.Distance(BallAt(0.1, {1.0, -0.75, 0.3}), 1.0, false), 0.2, 1e-5)
      << "far from it the ground is level";
  EXPECT_LT(peak.Distance(PlacedShape(ShapeType::kBox, {1.0, 1.0, 0.2}, {0.0, 0.0, 0.5}), 1.0, true), 0.0);
}

TEST(GridPrisms, AMovedGridAndShapeAreAsFarApart) {
  const auto hilly = [](double x, double y) { return 0.2 * x * y + 0.1 * x; };
  GridSolid grid = GridOf(hilly);
  const GridPrisms here(grid);
  const Vector3 move(300.0, -200.0, 5.0);
  grid.origin_W += move.head<2>();
  for (double& height : grid.height_m) height += move.z();
  const GridPrisms there(grid);
  for (const Vector3& p : {Vector3(0.1, 0.2, 0.4), Vector3(-0.6, 0.3, 0.25), Vector3(1.4, 0.1, 0.0)}) {
    const double distance = here.Distance(BallAt(0.1, p), 2.0, false);
    EXPECT_GT(distance, 0.0);
    EXPECT_NEAR(there.Distance(BallAt(0.1, p + move), 2.0, false), distance, 1e-5);
  }
}

TEST(GridPrisms, RefusesGridsThatAreNone) {
  const GridSolid fine = GridOf([](double, double) { return 0.0; });
  GridSolid narrow = fine, flat = fine, missing = fine, none = fine;
  narrow.columns = 1;
  flat.rows = 1;
  missing.height_m.pop_back();
  none.resolution_m = 0.0;
  EXPECT_NO_THROW(GridPrisms{fine});
  for (const GridSolid& wrong : {narrow, flat, missing, none}) EXPECT_THROW(GridPrisms{wrong}, InvalidArgument);
}

}  // namespace
}  // namespace gaitwright
