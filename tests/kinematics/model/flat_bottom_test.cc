// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/flat_bottom.h"

#include <gtest/gtest.h>

#include "kinematics/spatial/rotation.h"
#include "kinematics/stability/polygon.h"

namespace gaitwright {
namespace {

Shape BottomShape(ShapeType type, const Vector3& size, const Vector3& p_BS = Vector3::Zero()) {
  Shape shape;
  shape.type = type;
  shape.size = size;
  shape.link = "foot";
  shape.X_BS.translation() = p_BS;
  return shape;
}

Shape BottomMesh(std::vector<Vector3> vertices) {
  Shape shape = BottomShape(ShapeType::kMesh, Vector3::Ones());
  shape.mesh_file = "foot.stl";
  shape.vertices = std::move(vertices);
  return shape;
}

/// A disc as a mesh of 48 points on each of its faces.
Shape DiscMesh(double radius, double height) {
  std::vector<Vector3> vertices;
  for (int i = 0; i < 48; ++i) {
    const double turn = 2.0 * 3.14159265358979 * i / 48.0;
    for (const double z : {0.0, height}) vertices.emplace_back(radius * std::cos(turn), radius * std::sin(turn), z);
  }
  return BottomMesh(vertices);
}

TEST(SpanningCorners, SpanEachKindOfShape) {
  const std::vector<Vector3> centre = SpanningCorners(BottomShape(ShapeType::kSphere, {0.1, 0, 0}, {1, 2, 3}));
  ASSERT_EQ(centre.size(), 1U);
  EXPECT_EQ(centre[0], Vector3(1, 2, 3));
  EXPECT_EQ(RoundingRadius(BottomShape(ShapeType::kSphere, {0.1, 0, 0})), 0.1);
  const std::vector<Vector3> ends = SpanningCorners(BottomShape(ShapeType::kCapsule, {0.1, 0.6, 0}));
  ASSERT_EQ(ends.size(), 2U);
  EXPECT_EQ((ends[0] - ends[1]).norm(), 0.6);
  EXPECT_EQ(RoundingRadius(BottomShape(ShapeType::kBox, {1, 1, 1})), 0.0);
  for (const Shape& shape :
       {BottomShape(ShapeType::kBox, {0.2, 0.4, 0.6}), BottomShape(ShapeType::kCylinder, {0.1, 0.6, 0})}) {
    const std::vector<Vector3> corners = SpanningCorners(shape);
    ASSERT_EQ(corners.size(), 8U);
    for (const Vector3& corner : corners) {
      EXPECT_EQ(std::abs(corner.x()), 0.1);
      EXPECT_EQ(std::abs(corner.z()), 0.3);
    }
  }
}

TEST(FlatBottom, OfABoxIsItsLowerFace) {
  const Shape box = BottomShape(ShapeType::kBox, {0.2, 0.1, 0.04}, {0.03, 0.01, -0.05});
  Pose X_OE = Pose::Identity();
  X_OE.translation() = Vector3(1.0, 2.0, 3.0);
  Foot foot;
  ASSERT_TRUE(FindFlatBottom(X_OE, {&box}, std::nullopt, foot));
  EXPECT_LT((foot.X_BF.translation() - Vector3(0.03, 0.01, -0.07)).norm(), 1e-12);
  EXPECT_EQ(foot.sole_F.size(), 4U);
  EXPECT_NEAR(Area(foot.sole_F), 0.02, 1e-12);
  EXPECT_LT(Centroid(foot.sole_F).norm(), 1e-12);
}

TEST(FlatBottom, FollowsTheBodyWhereverItStands) {
  const Shape box = BottomShape(ShapeType::kBox, {0.2, 0.1, 0.04});
  Foot level, turned;
  Pose X_OE = Pose::Identity();
  ASSERT_TRUE(FindFlatBottom(X_OE, {&box}, std::nullopt, level));
  X_OE.translation() = Vector3(4.0, -1.0, 0.5);
  X_OE.linear() = RotationExp({3.14159265358979, 0.0, 0.0});  // upside down: the other face is the lower one
  ASSERT_TRUE(FindFlatBottom(X_OE, {&box}, std::nullopt, turned));
  EXPECT_NEAR(level.X_BF.translation().z(), -0.02, 1e-9);
  EXPECT_NEAR(turned.X_BF.translation().z(), 0.02, 1e-9);
  EXPECT_NEAR((X_OE * turned.X_BF).linear()(2, 2), 1.0, 1e-12) << "z of the sole is up";
}

TEST(FlatBottom, SeveralShapesSpanOneRectangleAndHigherOnesHaveNoPart) {
  std::vector<Shape> balls;
  for (const double x : {-0.1, 0.1}) {
    for (const double y : {-0.05, 0.05}) balls.push_back(BottomShape(ShapeType::kSphere, {0.01, 0, 0}, {x, y, 0.0}));
  }
  const Shape high = BottomShape(ShapeType::kBox, {1.0, 1.0, 0.01}, {0, 0, 0.1});
  Foot foot;
  ASSERT_TRUE(
      FindFlatBottom(Pose::Identity(), {&balls[0], &balls[1], &balls[2], &balls[3], &high}, std::nullopt, foot));
  EXPECT_NEAR(Area(foot.sole_F), 0.02, 1e-12);
  EXPECT_NEAR(foot.X_BF.translation().z(), -0.01, 1e-12);
  EXPECT_NE(foot.derived_from.find("4 spheres of link 'foot'"), std::string::npos) << foot.derived_from;
  EXPECT_FALSE(FindFlatBottom(Pose::Identity(), {&balls[0], &balls[1]}, std::nullopt, foot)) << "a line";
}

TEST(FlatBottom, OfADiscKeepsTwelveCornersAndMostOfItsArea) {
  const Shape disc = DiscMesh(0.1, 0.05);
  Foot foot;
  ASSERT_TRUE(FindFlatBottom(Pose::Identity(), {&disc}, std::nullopt, foot));
  EXPECT_EQ(foot.sole_F.size(), 12U);
  EXPECT_GT(Area(foot.sole_F), 0.95 * 3.1415 * 0.01);
  EXPECT_LT(Area(foot.sole_F), 3.1416 * 0.01);
}

TEST(FlatBottom, AMeshGivesByItsSizeAndAsTheUserSays) {
  // A tip of 1 cm on a plate 3 mm above: 2 % of 0.2 m is 4 mm.
  std::vector<Vector3> vertices;
  for (const double x : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0}) {
      vertices.emplace_back(0.011 * x, 0.011 * y, 0.0);
      vertices.emplace_back(0.1 * x, 0.05 * y, 0.003);
    }
  }
  const Shape mesh = BottomMesh(vertices);
  Foot rubber, hard;
  ASSERT_TRUE(FindFlatBottom(Pose::Identity(), {&mesh}, std::nullopt, rubber));
  EXPECT_NEAR(Area(rubber.sole_F), 0.02, 1e-9);
  ASSERT_TRUE(FindFlatBottom(Pose::Identity(), {&mesh}, 0.001, hard));
  EXPECT_NEAR(Area(hard.sole_F), 0.022 * 0.022, 1e-9);
  EXPECT_NE(hard.derived_from.find("1 mm"), std::string::npos) << hard.derived_from;
  Shape small = mesh;
  for (Vector3& v : small.vertices) v *= 0.4;  // a tip of less than 1 cm^2
  EXPECT_FALSE(FindFlatBottom(Pose::Identity(), {&small}, 0.0005, hard));
}

TEST(BottomTilt, IsTheTurnOfABottomThatIsALittleAslant) {
  const Shape box = BottomShape(ShapeType::kBox, {0.2, 0.1, 0.04});
  for (const Vector3& turn : {Vector3(0.0, 0.02, 0.0), Vector3(0.05, 0.0, 0.0), Vector3(0.01, -0.02, 0.0)}) {
    Pose X_OE = Pose::Identity();
    X_OE.linear() = RotationExp(turn);
    const Matrix3 R = BottomTilt(X_OE, {&box}).toRotationMatrix();
    EXPECT_LT((R.col(2) - X_OE.linear().col(2)).norm(), 1e-9) << turn.transpose();
  }
}

TEST(BottomTilt, IsNoneWhereThereIsNoPlaneOrItIsTooSteep) {
  const Shape ball = BottomShape(ShapeType::kSphere, {0.05, 0, 0}),
              box = BottomShape(ShapeType::kBox, {0.02, 0.02, 0.02});
  EXPECT_EQ(BottomTilt(Pose::Identity(), {&ball}).angularDistance(Eigen::Quaterniond::Identity()), 0.0);
  Pose steep = Pose::Identity();
  steep.linear() = RotationExp({0.0, 0.2, 0.0});
  EXPECT_EQ(BottomTilt(steep, {&box}).angularDistance(Eigen::Quaterniond::Identity()), 0.0);
}

TEST(NameOfShapes, TellsOneShapeFromSeveral) {
  const Shape box = BottomShape(ShapeType::kBox, {1, 1, 1}), ball = BottomShape(ShapeType::kSphere, {1, 0, 0});
  const Shape mesh = BottomMesh({});
  EXPECT_EQ(NameOfShapes({&box}), "the box of link 'foot'");
  EXPECT_EQ(NameOfShapes({&mesh}), "the mesh 'foot.stl' of link 'foot'");
  EXPECT_EQ(NameOfShapes({&box, &box}), "2 boxes of link 'foot'");
  EXPECT_EQ(NameOfShapes({&box, &ball, &mesh}), "3 shapes of link 'foot'");
}

}  // namespace
}  // namespace gaitwright
