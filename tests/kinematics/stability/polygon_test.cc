// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/stability/polygon.h"

#include <gtest/gtest.h>

#include <random>

#include "kinematics/base/result.h"
#include "tests/kinematics/drawn.h"

namespace gaitwright {
namespace {

TEST(Polygon, HullHoldsItsPointsAndTurnsLeft) {
  std::mt19937 engine(3);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 100; ++trial) {
    std::vector<Vector2> points;
    for (int i = 0; i < 20; ++i) points.push_back(Drawn<Vector2>(normal, engine));
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

/// A convex polygon of random size and position, from a seed.
Polygon RandomPolygon(std::mt19937& engine) {
  std::normal_distribution<double> normal;
  std::vector<Vector2> points;
  for (int i = 0; i < 8; ++i) points.push_back(Drawn<Vector2>(normal, engine));
  return ConvexHull(points);
}

TEST(Clipped, RectanglesInClosedForm) {
  const Polygon rectangle = ConvexHull({{0.0, 0.0}, {3.0, 0.0}, {3.0, 2.0}, {0.0, 2.0}});
  const Polygon right = Clipped(rectangle, {1.0, 0.0}, 1.0);
  EXPECT_NEAR(Area(right), 4.0, 1e-12);
  EXPECT_NEAR((Centroid(right) - Vector2(2.0, 1.0)).norm(), 0.0, 1e-12);
  const Polygon below = Clipped(rectangle, {0.0, -2.0}, -1.0);  // y <= 1/2
  EXPECT_NEAR(Area(below), 1.5, 1e-12);
  EXPECT_NEAR((Centroid(below) - Vector2(1.5, 0.25)).norm(), 0.0, 1e-12);
  EXPECT_NEAR(Area(Clipped(rectangle, {1.0, 1.0}, 4.0)), 0.5, 1e-12);
  EXPECT_EQ(Clipped(rectangle, {1.0, 1.0}, 4.0).size(), 3U);
  EXPECT_TRUE(Clipped(rectangle, {1.0, 0.0}, 3.5).empty());
  EXPECT_EQ(Clipped(rectangle, {1.0, 0.0}, -0.5), rectangle);
}

TEST(Clipped, IsConvexInsideOnTheSideAndTheTwoSidesMakeTheWhole) {
  std::mt19937 engine(11);
  std::normal_distribution<double> random;
  int cut = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const Polygon whole = RandomPolygon(engine);
    const Vector2 normal(random(engine), random(engine));
    const double least = random(engine);
    const Polygon part = Clipped(whole, normal, least), other = Clipped(whole, -normal, -least);
    for (const Vector2& p : part) {
      EXPECT_GE(normal.dot(p), least - 1e-12);
      EXPECT_GE(SignedDistance(whole, p), -1e-12);
    }
    EXPECT_NEAR(Area(part) + Area(other), Area(whole), 1e-12);
    EXPECT_NEAR(Area(ConvexHull(part)), Area(part), 1e-12);
    cut += static_cast<int>(Area(part) > 1e-3 && Area(other) > 1e-3);
  }
  EXPECT_GT(cut, 100);
}

TEST(Clipped, TwiceIsOnce) {
  std::mt19937 engine(13);
  std::normal_distribution<double> random;
  for (int trial = 0; trial < 300; ++trial) {
    const Polygon whole = RandomPolygon(engine);
    const Vector2 normal(random(engine), random(engine));
    const Polygon once = Clipped(whole, normal, 0.3), twice = Clipped(once, normal, 0.3 - 1e-12);
    EXPECT_EQ(once, twice);
    const Vector2 across(random(engine), random(engine));
    EXPECT_NEAR(Area(Clipped(once, across, 0.1)), Area(Clipped(Clipped(whole, across, 0.1), normal, 0.3)), 1e-12);
  }
}

}  // namespace
}  // namespace gaitwright
