// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/solid_inertia.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/kinematics/model/small_urdf.h"
#include "tests/kinematics/random_state.h"

namespace gaitwright {
namespace {

Shape Made(ShapeType type, const Vector3& size, const Vector3& at = Vector3::Zero()) {
  Shape shape;
  shape.type = type;
  shape.size = size;
  shape.X_BS.translation() = at;
  return shape;
}

Matrix3 InertiaOf(const std::vector<Shape>& shapes, double mass) {
  std::vector<const Shape*> all;
  for (const Shape& shape : shapes) all.push_back(&shape);
  return SolidInertia(all, mass).value();
}

TEST(SolidInertia, IsThatOfTextbooks) {
  EXPECT_LT((InertiaOf({Made(ShapeType::kBox, {0.2, 0.4, 0.6})}, 12.0).diagonal() - Vector3(0.52, 0.40, 0.20)).norm(),
            1e-12);
  EXPECT_LT((InertiaOf({Made(ShapeType::kSphere, {0.5, 0.0, 0.0})}, 10.0).diagonal() - Vector3::Constant(1.0)).norm(),
            1e-12);
  const Matrix3 rod = InertiaOf({Made(ShapeType::kCylinder, {0.2, 0.6, 0.0})}, 4.0);
  EXPECT_LT((rod.diagonal() - Vector3(0.16, 0.16, 0.08)).norm(), 1e-12);
}

/// The published table of the humanoid contains the inertia that Bullet computes for its thigh.
TEST(SolidInertia, ACapsuleIsAsPublished) {
  const Matrix3 thigh = InertiaOf({Made(ShapeType::kCapsule, {0.055, 0.3, 0.0})}, 4.5);
  EXPECT_LT((thigh.diagonal() - Vector3(0.0562824, 0.0562824, 0.00653886)).norm(), 1e-7);
}

TEST(SolidInertia, HalvesMakeAWholeWhereverTheyAre) {
  const Matrix3 whole = InertiaOf({Made(ShapeType::kBox, {0.2, 0.4, 0.6})}, 3.0);
  const Matrix3 halves = InertiaOf({Made(ShapeType::kBox, {0.1, 0.4, 0.6}, {1.0, 2.0, 3.0}),
                                    Made(ShapeType::kBox, {0.1, 0.4, 0.6}, {1.1, 2.0, 3.0})},
                                   3.0);
  EXPECT_LT((whole - halves).norm(), 1e-12);
  EXPECT_FALSE(SolidInertia({}, 1.0).has_value());
}

TEST(SolidInertia, HasNoDensityThatOverflows) {
  for (const double thin : {0.0, 1e-320, 1e-300, 1e-40}) {
    const Shape disc = Made(ShapeType::kCylinder, {0.05, thin, 0.0});
    EXPECT_FALSE(SolidInertia({&disc}, 1.0).has_value()) << thin;
  }
  EXPECT_TRUE(InertiaOf({Made(ShapeType::kCylinder, {0.05, 1e-20, 0.0})}, 1.0).allFinite());
}

TEST(SolidInertia, StandsInForWhatAUrdfLeavesOut) {
  const std::string zero = Replaced(FourLegs(), "ixx='0.01' iyy='0.01' izz='0.01'", "ixx='0' iyy='0' izz='0'");
  const RobotModel model = LoadRobotFromText(zero, "").value();
  const Matrix3 trunk = InertiaOf({Made(ShapeType::kBox, {0.4, 0.2, 0.1})}, 1.0);
  EXPECT_LT((model.bodies.front().I_C - trunk).norm(), 1e-12);
  std::vector<std::string> parts;
  for (const Finding& finding : model.findings) {
    EXPECT_EQ(finding.code, FailureCode::kImpossibleInertia);
    parts.push_back(PartText(finding.part));
  }
  EXPECT_EQ(std::count(parts.begin(), parts.end(), "link 'trunk'"), 1);
  EXPECT_EQ(std::count(parts.begin(), parts.end(), "link 'A_thigh'"), 0) << "it has no shapes";
}

TEST(SolidInertia, StandsInForOneThatAllLinksHaveWhateverTheyWeigh) {
  const std::string urdf = FourLegs();
  const std::string heavier = Replaced(urdf, "<link name='trunk'><inertial><mass value='1'/>",
                                       "<link name='trunk'><inertial><mass value='2'/>");
  EXPECT_NEAR(LoadRobotFromText(urdf, "").value().bodies.front().I_C(0, 0), 0.01, 1e-12) << "all weigh the same";
  EXPECT_NEAR(LoadRobotFromText(heavier, "").value().bodies.front().I_C(0, 0), 2.0 * 0.05 / 12.0, 1e-12);
}

}  // namespace
}  // namespace gaitwright
