// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/spatial/solid_hull.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "kinematics/base/random.h"

namespace gaitwright {
namespace {

using Points = std::vector<Vector3>;
using Triangles = std::vector<Eigen::Vector3i>;

const Vector3& At(const Points& points, int i) { return points[static_cast<std::size_t>(i)]; }

double VolumeOf(const Points& points, const Triangles& triangles) {
  double six = 0.0;
  for (const Eigen::Vector3i& t : triangles) {
    const Vector3 a = At(points, t[0]) - points[0], b = At(points, t[1]) - points[0], c = At(points, t[2]) - points[0];
    six += a.dot(b.cross(c));
  }
  return six / 6.0;
}

/// Expects a closed surface: each edge belongs to two triangles, once in each direction, and no point is outside.
void ExpectHull(const Points& points, const Triangles& triangles, double rounding = 1e-9) {
  std::map<std::pair<int, int>, int> edges;
  for (const Eigen::Vector3i& t : triangles) {
    for (int i = 0; i < 3; ++i) ++edges[{t[i], t[(i + 1) % 3]}];
    const Vector3 normal = (At(points, t[1]) - At(points, t[0])).cross(At(points, t[2]) - At(points, t[0]));
    ASSERT_GT(normal.norm(), 0.0);
    for (const Vector3& p : points) ASSERT_LE(normal.normalized().dot(p - At(points, t[0])), rounding);
  }
  for (const auto& [edge, count] : edges) {
    EXPECT_EQ(count, 1);
    EXPECT_TRUE(edges.contains({edge.second, edge.first}));
  }
}

Points BoxCorners(const Vector3& size) {
  Points corners;
  for (int i = 0; i < 8; ++i) corners.push_back(Vector3(i & 1, (i >> 1) & 1, i >> 2).cwiseProduct(size));
  return corners;
}

TEST(HullTriangles, OfABoxAreTwoASide) {
  Points box = BoxCorners({1.0, 2.0, 3.0});
  EXPECT_EQ(HullTriangles(box).size(), 12U);
  ExpectHull(box, HullTriangles(box));
  EXPECT_NEAR(VolumeOf(box, HullTriangles(box)), 6.0, 1e-12);
  for (const Vector3& inside : {Vector3(0.5, 1.0, 1.0), Vector3(0.5, 1.0, 0.0), Vector3(0.5, 0.0, 0.0), box[3]})
    box.push_back(inside);  // inside, on a side, on an edge, and a duplicate corner
  EXPECT_EQ(HullTriangles(box).size(), 12U);
  ExpectHull(box, HullTriangles(box));
}

TEST(HullTriangles, AreTheSameSolidWhereverItLies) {
  Points far;
  const Eigen::AngleAxisd turn(0.7, Vector3(1.0, 2.0, 3.0).normalized());
  for (const Vector3& corner : BoxCorners({0.1, 0.2, 0.3})) far.push_back(turn * corner + Vector3(900.0, -700.0, 20.0));
  EXPECT_EQ(HullTriangles(far).size(), 12U);
  EXPECT_NEAR(VolumeOf(far, HullTriangles(far)), 0.006, 1e-9);
}

TEST(HullTriangles, OfAPrismAndOfRandomPointsAreClosed) {
  constexpr int kSides = 32;
  Points prism;
  for (int side = 0; side < kSides; ++side) {
    const double turn = 2.0 * std::numbers::pi * side / kSides;
    for (const double height : {0.0, 1.0}) prism.emplace_back(std::cos(turn), std::sin(turn), height);
  }
  const Triangles sides = HullTriangles(prism);
  EXPECT_EQ(sides.size(), 2U * (2 * kSides) - 4U) << "Euler: all points are corners";
  ExpectHull(prism, sides);
  EXPECT_NEAR(VolumeOf(prism, sides), 0.5 * kSides * std::sin(2.0 * std::numbers::pi / kSides), 1e-12);
  SplitMix random(2);
  for (const int count : {5, 20, 300}) {
    Points cloud, sphere;
    for (int i = 0; i < count; ++i) {
      cloud.emplace_back(random.Normal(), random.Normal(), random.Normal());
      sphere.push_back(cloud.back().normalized());
    }
    ExpectHull(cloud, HullTriangles(cloud));
    ExpectHull(sphere, HullTriangles(sphere));
    EXPECT_EQ(HullTriangles(sphere).size(), 2U * sphere.size() - 4U);
  }
}

TEST(HullTriangles, AreNoneWithoutVolume) {
  EXPECT_TRUE(HullTriangles({}).empty());
  EXPECT_TRUE(HullTriangles(Points(5, Vector3(1.0, 2.0, 3.0))).empty());
  EXPECT_TRUE(HullTriangles({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}}).empty());
  EXPECT_TRUE(HullTriangles({{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}, {0.5, 0.5, 1}}).empty());
}

}  // namespace
}  // namespace gaitwright
