// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/stability/polygon.h"

#include <gtest/gtest.h>

#include <random>

#include "kinematics/base/result.h"

namespace gaitwright {
namespace {

TEST(Polygon, HullHoldsItsPointsAndTurnsLeft) {
  std::mt19937 engine(3);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 100; ++trial) {
    std::vector<Vector2> points;
    for (int i = 0; i < 20; ++i) points.emplace_back(normal(engine), normal(engine));
    const Polygon hull = ConvexHull(points);
    ASSERT_GE(hull.size(), 3U);
    EXPECT_GT(Area(hull), 0.0);
    for (const Vector2& p : points) EXPECT_GT(SignedDistance(hull, p), -1e-12);
    EXPECT_GT(SignedDistance(hull, Centroid(hull)), 0.0);
  }
}

TEST(Polygon, CornersNearlyInLineAreNotLost) {
  std::mt19937 engine(5);
  std::normal_distribution<double> noise(0.0, 1e-11);
  for (int trial = 0; trial < 1000; ++trial) {
    std::vector<Vector2> corners;
    for (const double y : {-0.1, -0.012, 0.012, 0.1}) {
      for (const double x : {-0.05, 0.11}) corners.emplace_back(x + noise(engine), y + noise(engine));
    }
    EXPECT_NEAR(Area(ConvexHull(corners)), 0.16 * 0.2, 1e-9);
  }
}

TEST(Polygon, SquareInClosedForm) {
  const Polygon square = ConvexHull({{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}, {0.5, 0.5}, {0.5, 0.0}});
  EXPECT_EQ(square.size(), 4U);
  EXPECT_DOUBLE_EQ(Area(square), 1.0);
  EXPECT_DOUBLE_EQ(SignedDistance(square, {0.2, 0.5}), 0.2);
  EXPECT_DOUBLE_EQ(SignedDistance(square, {-0.3, 0.5}), -0.3);
  EXPECT_NEAR(SignedDistance(square, {2.0, 2.0}), -std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(Area(Shrunk(square, 0.1)), 0.64, 1e-12);
  EXPECT_TRUE(Shrunk(square, 0.6).empty());
  EXPECT_LT((NearestPoint(square, {2.0, 0.5}) - Vector2(1.0, 0.5)).norm(), 1e-12);
}

TEST(Polygon, SegmentsAndPointsHaveNoInside) {
  const Polygon segment = ConvexHull({{0.0, 0.0}, {1.0, 0.0}});
  EXPECT_DOUBLE_EQ(SignedDistance(segment, {0.5, 0.0}), 0.0);
  EXPECT_DOUBLE_EQ(SignedDistance(segment, {0.5, 0.2}), -0.2);
  EXPECT_DOUBLE_EQ(SignedDistance(ConvexHull({{1.0, 1.0}}), {1.0, 3.0}), -2.0);
  EXPECT_THROW(SignedDistance({}, {0.0, 0.0}), InvalidArgument);
}

}  // namespace
}  // namespace gaitwright
