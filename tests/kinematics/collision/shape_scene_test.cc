// SPDX-License-Identifier: BSD-3-Clause
// Distances compared with closed forms and with an independent computation by triangles. Results do not depend on
// earlier queries.
#include "kinematics/collision/shape_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <utility>

#include "kinematics/base/result.h"

namespace gaitwright {
namespace {

constexpr double kSolver = 3e-5;  // [m] largest error of distances

Shape Of(ShapeType type, const Vector3& size, const Vector3& p_WS = Vector3::Zero(), const std::string& name = "") {
  Shape shape;
  shape.type = type;
  shape.size = size;
  shape.link = name;
  shape.X_BS.translation() = p_WS;
  return shape;
}

Shape Ball(double radius_m) { return Of(ShapeType::kSphere, {radius_m, 0.0, 0.0}); }

Pose At(const Vector3& p_WS) {
  Pose X_WS = Pose::Identity();
  X_WS.translation() = p_WS;
  return X_WS;
}

/// Distance of a point outside a box about the origin.
double ToBox(const Vector3& size, const Vector3& p) { return (p.cwiseAbs() - 0.5 * size).cwiseMax(0.0).norm(); }

class Points {
 public:
  explicit Points(unsigned seed) : random_(seed) {}
  Vector3 In(const Vector3& low, const Vector3& high) {
    Vector3 p;
    for (int i = 0; i < 3; ++i) p[i] = low[i] + (high[i] - low[i]) * uniform_(random_);
    return p;
  }

 private:
  std::mt19937 random_;
  std::uniform_real_distribution<double> uniform_{0.0, 1.0};
};

TEST(ShapeScene, BallsAgainstBoxesAsTheClosedFormHasIt) {
  const Vector3 size(0.4, 0.6, 0.2), lateral(1.0, 0.0, 0.3);
  const ShapeScene scene(
      {Of(ShapeType::kBox, size, Vector3::Zero(), "near"), Of(ShapeType::kBox, size, lateral, "aside")});
  constexpr double kRadius = 0.05, kWithin = 0.5;
  const PreparedShape ball(Ball(kRadius));
  Points points(3);
  int touching = 0, far = 0;
  for (int k = 0; k < 2000; ++k) {
    const Vector3 p = points.In({-1.0, -1.0, -1.0}, {2.0, 1.0, 1.0});
    const double to_near = ToBox(size, p) - kRadius, to_lateral = ToBox(size, p - lateral) - kRadius;
    const double expected = std::min({to_near, to_lateral, kWithin});
    if (std::abs(expected) < kSolver) continue;
    const NearestSolid nearest = scene.Nearest(ball, At(p), kWithin);
    EXPECT_EQ(scene.Touches(ball, At(p)), expected < 0.0) << p.transpose();
    if (expected == kWithin) {
      EXPECT_EQ(nearest.solid, -1);
      EXPECT_EQ(nearest.distance_m, kWithin);
      ++far;
      continue;
    }
    EXPECT_EQ(scene.SolidName(nearest.solid), to_near < to_lateral ? "near" : "aside");
    if (expected > 0.0) {
      EXPECT_NEAR(nearest.distance_m, expected, kSolver) << p.transpose();
      EXPECT_LE(nearest.distance_m, expected + 1e-9);
    } else {
      EXPECT_LT(nearest.distance_m, 0.0);
      ++touching;
    }
  }
  EXPECT_GT(touching, 20);
  EXPECT_GT(far, 100);
}

TEST(ShapeScene, DepthsAreThoseToTheNearestFace) {
  // The solid under a tread, one metre deep, given by its corners.
  Shape tread = Of(ShapeType::kMesh, Vector3::Ones(), Vector3(0.0, 0.0, -0.5));
  for (const double x : {-1.5, 1.5}) {
    for (const double y : {-2.0, 2.0}) {
      for (const double z : {-0.5, 0.5}) tread.vertices.emplace_back(x, y, z);
    }
  }
  const ShapeScene scene({tread});
  const PreparedShape ball(Ball(0.02)), sole(Of(ShapeType::kBox, {0.16, 0.08, 0.02}));
  for (const double depth : {1e-4, 1e-3, 4e-3}) {
    for (const double x : {-1.3, 0.0, 1.47}) {
      EXPECT_NEAR(scene.Distance(ball, At({x, 1.2, 0.02 - depth}), 0.1), -depth, kSolver + 0.02 * depth);
      EXPECT_NEAR(scene.Distance(sole, At({x, 1.2, 0.01 - depth}), 0.1), -depth, kSolver + 0.02 * depth);
    }
    // Beside a riser, whose face is at x = 1.5.
    EXPECT_NEAR(scene.Distance(ball, At({1.52 - depth, 0.3, -0.2}), 0.1), -depth, kSolver + 0.02 * depth);
    EXPECT_NEAR(scene.Distance(sole, At({1.58 - depth, 0.3, -0.2}), 0.1), -depth, kSolver + 0.02 * depth);
  }
}

TEST(ShapeScene, HalfSpacesAreExact) {
  const Vector3 normal = Vector3(0.3, -0.2, 1.0).normalized();
  const ShapeScene scene({}, {}, {{"slope", normal, 0.25}});
  Points points(5);
  for (int k = 0; k < 100; ++k) {
    const Vector3 p = points.In({-1.0, -1.0, -1.0}, {1.0, 1.0, 1.0});
    const double expected = normal.dot(p) - 0.25 - 0.1;
    EXPECT_NEAR(scene.Distance(Ball(0.1), At(p), 10.0), expected, 1e-12);
    EXPECT_EQ(scene.Touches(Ball(0.1), At(p)), expected <= 0.0);
  }
}

GridSolid Field(int columns, int rows, double resolution_m, double amplitude_m) {
  GridSolid grid;
  grid.name = "field";
  grid.origin_W = {-0.3, -0.2};
  grid.resolution_m = resolution_m;
  grid.columns = columns;
  grid.rows = rows;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column)
      grid.height_m.push_back(amplitude_m * std::sin(1.3 * column + 0.4 * row) * std::cos(0.9 * row));
  }
  return grid;
}

double ToSegment(const Vector3& a, const Vector3& b, const Vector3& p) {
  const double t = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
  return (p - a - t * (b - a)).norm();
}

double ToTriangle(const std::array<Vector3, 3>& c, const Vector3& p) {
  const Vector3 normal = (c[1] - c[0]).cross(c[2] - c[0]).normalized();
  bool inside = true;
  double edges = 1e9;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector3 &a = c[i], &b = c[(i + 1) % 3];
    inside = inside && normal.dot((b - a).cross(p - a)) >= 0.0;
    edges = std::min(edges, ToSegment(a, b, p));
  }
  return inside ? std::abs(normal.dot(p - c[0])) : edges;
}

/// The distance of a point above a field, by all its triangles.
double ToField(const GridSolid& grid, const Vector3& p) {
  double nearest = 1e9;
  const auto node = [&](int column, int row) {
    const Vector2 at = grid.origin_W + grid.resolution_m * Vector2(column, row);
    return Vector3(at.x(), at.y(), grid.height_m[static_cast<std::size_t>(row * grid.columns + column)]);
  };
  for (int row = 0; row + 1 < grid.rows; ++row) {
    for (int column = 0; column + 1 < grid.columns; ++column) {
      const Vector3 low = node(column, row), high = node(column + 1, row + 1);
      nearest = std::min(nearest, ToTriangle({low, node(column + 1, row), high}, p));
      nearest = std::min(nearest, ToTriangle({low, high, node(column, row + 1)}, p));
    }
  }
  return nearest;
}

TEST(ShapeScene, BallsAboveAFieldAsItsTrianglesHaveIt) {
  const GridSolid grid = Field(30, 20, 0.03, 0.04);
  const ShapeScene scene({}, {grid});
  const PreparedShape ball(Ball(0.02));
  Points points(7);
  for (int k = 0; k < 500; ++k) {
    const Vector3 p = points.In({-0.35, -0.25, 0.06}, {0.62, 0.42, 0.2});
    EXPECT_NEAR(scene.Distance(ball, At(p), 1.0), ToField(grid, p) - 0.02, kSolver) << p.transpose();
  }
}

TEST(ShapeScene, AFieldIsSolidBelow) {
  const GridSolid grid = Field(30, 20, 0.03, 0.04);
  const ShapeScene scene({}, {grid});
  const Shape ball = Ball(0.005), box = Of(ShapeType::kBox, {0.01, 0.01, 0.3});
  for (const double x : {-0.25, 0.0, 0.21}) {
    EXPECT_TRUE(scene.Touches(ball, At({x, 0.1, -0.4}))) << "wholly under the surface";
    EXPECT_LT(scene.Distance(ball, At({x, 0.1, -0.4}), 1.0), 0.0);
    EXPECT_TRUE(scene.Touches(box, At({x, 0.1, 0.1}))) << "through the surface";
    EXPECT_FALSE(scene.Touches(ball, At({x, 0.1, 0.06})));
    EXPECT_FALSE(scene.Touches(ball, At({x, 0.1, -1.2}))) << "below the solid";
  }
  EXPECT_FALSE(scene.Touches(ball, At({-0.32, 0.1, -0.4}))) << "beside it";
  EXPECT_NEAR(scene.Distance(ball, At({-0.32, 0.1, -0.4}), 1.0), 0.015, kSolver);
}

TEST(ShapeScene, AnswersDoNotDependOnWhatWasAskedBefore) {
  const std::vector<Shape> fixed = {Of(ShapeType::kBox, {0.3, 0.3, 0.3}, {0.2, 0.0, 0.1}),
                                    Of(ShapeType::kCylinder, {0.1, 0.5, 0.0}, {-0.2, 0.1, 0.2})};
  const GridSolid grid = Field(20, 20, 0.04, 0.03);
  ShapeScene made(fixed, {grid});
  const ShapeScene scene = std::move(made);
  const PreparedShape capsule(Of(ShapeType::kCapsule, {0.03, 0.2, 0.0}));
  Points points(11);
  for (int k = 0; k < 100; ++k) {
    Pose X_WS = At(points.In({-0.4, -0.3, -0.1}, {0.5, 0.4, 0.5}));
    X_WS.linear() = Eigen::AngleAxisd(3.0 * points.In({0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}).x(), Vector3::UnitY()).matrix();
    const NearestSolid asked = scene.Nearest(capsule, X_WS, 0.2);
    const ShapeScene fresh(fixed, {grid});
    const NearestSolid first = fresh.Nearest(PreparedShape(capsule.shape()), X_WS, 0.2);
    EXPECT_EQ(asked.distance_m, first.distance_m);
    EXPECT_EQ(asked.solid, first.solid);
    EXPECT_EQ(scene.Touches(capsule, X_WS), asked.distance_m <= 0.0);
  }
}

TEST(ShapeScene, WhatHasNoPointsTouchesNothing) {
  const ShapeScene scene({Of(ShapeType::kMesh, Vector3::Ones(), Vector3::Zero(), "empty")});
  EXPECT_EQ(scene.num_solids(), 1);
  EXPECT_FALSE(scene.Touches(Ball(1.0), At(Vector3::Zero())));
  const ShapeScene box({Of(ShapeType::kBox, Vector3::Ones())});
  EXPECT_FALSE(box.Touches(Of(ShapeType::kMesh, Vector3::Ones()), At(Vector3::Zero())));
  EXPECT_EQ(box.Distance(Of(ShapeType::kMesh, Vector3::Ones()), At(Vector3::Zero()), 0.3), 0.3);
}

TEST(ShapeScene, SaysWhatIsWrong) {
  const ShapeScene scene({Of(ShapeType::kBox, Vector3::Ones())});
  EXPECT_THROW(scene.SolidName(1), InvalidArgument);
  EXPECT_THROW(scene.SolidName(-1), InvalidArgument);
  GridSolid grid = Field(4, 4, 0.1, 0.0);
  grid.height_m.pop_back();
  try {
    const ShapeScene bad({}, {grid});
    FAIL() << "a height is missing";
  } catch (const InvalidArgument& error) {
    EXPECT_NE(std::string(error.what()).find("grid 'field' has 15 heights for 4 columns and 4 rows"), std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace gaitwright
