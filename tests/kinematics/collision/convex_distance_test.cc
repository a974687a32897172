// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "kinematics/collision/convex_distance_internal.h"
#include "kinematics/collision/fcl_shape_internal.h"
#include "kinematics/model/shape_support.h"
#include "kinematics/spatial/rotation.h"
#include "tests/kinematics/random_state.h"

namespace gaitwright {
namespace {

Shape Made(ShapeType type, const Vector3& size) {
  Shape shape;
  shape.type = type;
  shape.size = size;
  return shape;
}

Pose At(double x, double y, double z) {
  Pose X_WS = Pose::Identity();
  X_WS.translation() = Vector3(x, y, z);
  return X_WS;
}

/// A mesh of random points.
Shape Cloud(RandomState& random, int points) {
  Shape cloud = Made(ShapeType::kMesh, Vector3::Ones());
  for (int i = 0; i < points; ++i) cloud.vertices.emplace_back(0.1 * random.Vector(3));
  return cloud;
}

std::vector<Shape> OneOfEach(RandomState& random) {
  return {Made(ShapeType::kBox, {0.1, 0.2, 0.06}), Made(ShapeType::kSphere, {0.05, 0.0, 0.0}),
          Made(ShapeType::kCylinder, {0.05, 0.2, 0.0}), Made(ShapeType::kCapsule, {0.03, 0.15, 0.0}),
          Cloud(random, 12)};
}

Pose RandomPose(RandomState& random, double far_m) {
  Pose X_WS = Pose::Identity();
  X_WS.linear() = RotationExp(2.0 * random.Vector(3));
  X_WS.translation() = far_m * random.Vector(3);
  return X_WS;
}

/// How far B is beyond A along n.
double ApartAlong(const Shape& A, const Pose& X_WA, const Shape& B, const Pose& X_WB, const Vector3& n_W) {
  const Vector3 p_WA = X_WA * SupportPoint(A, X_WA.linear().transpose() * n_W),
                p_WB = X_WB * SupportPoint(B, -X_WB.linear().transpose() * n_W);
  return n_W.dot(p_WB - p_WA);
}

TEST(ConvexDistance, KnownDistancesAndDepths) {
  const Shape box = Made(ShapeType::kBox, {0.2, 0.4, 0.6}), ball = Made(ShapeType::kSphere, {0.1, 0.0, 0.0}),
              rod = Made(ShapeType::kCapsule, {0.05, 0.4, 0.0}), can = Made(ShapeType::kCylinder, {0.1, 0.5, 0.0});
  const Pose here = At(0.0, 0.0, 0.0);
  EXPECT_NEAR(DistanceOf(box, here, box, At(0.25, 0.1, 0.1)).distance_m, 0.05, 1e-12);
  EXPECT_NEAR(DistanceOf(box, here, box, At(0.25, 0.45, 0.1)).distance_m, std::hypot(0.05, 0.05), 1e-12);
  EXPECT_NEAR(DistanceOf(box, here, box, At(0.17, 0.1, 0.1)).distance_m, -0.03, 1e-12);
  EXPECT_NEAR(DistanceOf(box, here, box, here).distance_m, -0.2, 1e-12);
  EXPECT_NEAR(DistanceOf(ball, here, ball, At(0.0, 0.0, 0.15)).distance_m, -0.05, 1e-12);
  EXPECT_NEAR(DistanceOf(ball, here, ball, here).distance_m, -0.2, 1e-12);
  EXPECT_NEAR(DistanceOf(box, here, ball, At(0.15, 0.0, 0.0)).distance_m, -0.05, 1e-12);
  EXPECT_NEAR(DistanceOf(ball, At(0.04, 0.0, 0.0), box, here).distance_m, -0.16, 1e-12) << "centre inside";
  EXPECT_NEAR(DistanceOf(rod, here, rod, At(0.3, 0.0, 0.2)).distance_m, 0.2, 1e-12);
  EXPECT_NEAR(DistanceOf(rod, here, ball, At(0.0, 0.0, 0.3)).distance_m, -0.05, 1e-12);
  EXPECT_NEAR(DistanceOf(can, here, can, At(0.3, 0.1, 0.4)).distance_m, std::hypot(0.3, 0.1) - 0.2, 1e-9);
  EXPECT_NEAR(DistanceOf(can, here, can, At(0.12, 0.0, 0.1)).distance_m, -0.08, 1e-9);
}

TEST(ConvexDistance, RodsThatCrossAndCoresInAPlaneHaveADepth) {
  const Shape rod = Made(ShapeType::kCapsule, {0.05, 0.4, 0.0});
  Pose X_WB = At(0.01, 0.0, 0.02);
  X_WB.linear() = RotationExp({M_PI / 2.0, 0.0, 0.0});
  const ConvexDistance apart = DistanceOf(rod, At(0.0, 0.0, 0.0), rod, X_WB);
  EXPECT_NEAR(apart.distance_m, 0.01 - 0.1, 1e-12);
  X_WB.translation().x() = 0.0;
  const ConvexDistance crossing = DistanceOf(rod, At(0.0, 0.0, 0.0), rod, X_WB);
  EXPECT_NEAR(crossing.distance_m, -0.1, 1e-12);
  EXPECT_NEAR(std::abs(crossing.n_W.x()), 1.0, 1e-9) << "out of the plane of both axes";
  EXPECT_NEAR(DistanceOf(rod, At(0.0, 0.0, 0.0), rod, At(0.0, 0.0, 0.1)).distance_m, -0.1, 1e-12) << "one axis";
}

/// The definition: the witness direction reaches the distance, and no other direction exceeds it.
TEST(ConvexDistance, IsTheLargestSeparationOverAllDirections) {
  RandomState random(3);
  int overlaps = 0, apart = 0;
  for (int trial = 0; trial < 40; ++trial) {
    const std::vector<Shape> shapes = OneOfEach(random);
    for (const Shape& A : shapes) {
      for (const Shape& B : shapes) {
        const Pose X_WA = RandomPose(random, 0.08), X_WB = RandomPose(random, 0.12);
        const ConvexDistance at = DistanceOf(A, X_WA, B, X_WB);
        (at.distance_m < 0.0 ? overlaps : apart) += 1;
        EXPECT_NEAR(at.n_W.norm(), 1.0, 1e-12);
        const bool curved = A.type == ShapeType::kCylinder || B.type == ShapeType::kCylinder;
        EXPECT_LT((at.p_WB - at.p_WA - at.distance_m * at.n_W).norm(), curved ? 3e-5 : 1e-9);
        EXPECT_NEAR(ApartAlong(A, X_WA, B, X_WB, at.n_W), at.distance_m, 2e-9);
        for (int other = 0; other < 20; ++other) {
          const Vector3 n_W = (at.n_W + (other < 10 ? 0.05 : 2.0) * Vector3(random.Vector(3))).normalized();
          EXPECT_LE(ApartAlong(A, X_WA, B, X_WB, n_W), at.distance_m + 2e-9);
        }
      }
    }
  }
  EXPECT_GT(overlaps, 200);
  EXPECT_GT(apart, 200);
}

TEST(ConvexDistance, IsThatOfFclForShapesThatAreApart) {
  RandomState random(5);
  for (int trial = 0; trial < 20; ++trial) {
    const std::vector<Shape> shapes = OneOfEach(random);
    for (const Shape& A : shapes) {
      for (const Shape& B : shapes) {
        const Pose X_WA = RandomPose(random, 0.1), X_WB = RandomPose(random, 0.25);
        const double here = DistanceOf(A, X_WA, B, X_WB).distance_m;
        const double theirs =
            SignedGap(fcl::CollisionObjectd(FclGeometry(A), X_WA), fcl::CollisionObjectd(FclGeometry(B), X_WB));
        if (here > 1e-4) {
          EXPECT_NEAR(theirs, here, 5e-5);
        } else if (here < -1e-4) {
          EXPECT_LT(theirs, 0.0);
          EXPECT_LE(theirs, here + 1e-4) << "no depth is less than the least";
        }
      }
    }
  }
}

TEST(ConvexDistance, ChangesSideWithTheShapes) {
  RandomState random(9);
  for (int trial = 0; trial < 30; ++trial) {
    const Shape A = Cloud(random, 10), B = Cloud(random, 10);
    const Pose X_WA = RandomPose(random, 0.1), X_WB = RandomPose(random, 0.1);
    const ConvexDistance there = DistanceOf(A, X_WA, B, X_WB), back = DistanceOf(B, X_WB, A, X_WA);
    EXPECT_NEAR(there.distance_m, back.distance_m, 1e-12);
    EXPECT_LT((there.n_W + back.n_W).norm(), 1e-7);
  }
}

}  // namespace
}  // namespace gaitwright
