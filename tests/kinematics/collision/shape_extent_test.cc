// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/collision/shape_extent.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "kinematics/model/load_robot.h"
#include "tests/kinematics/model/small_urdf.h"

namespace gaitwright {
namespace {

Shape ShapeOf(ShapeType type, const Vector3& size) {
  Shape shape;
  shape.type = type;
  shape.size = size;
  return shape;
}

TEST(ShapeExtent, SupportPointsAreKnown) {
  const Vector3 slanted(1.0, 0.0, -1.0);
  EXPECT_EQ(SupportPoint(ShapeOf(ShapeType::kBox, {0.2, 0.4, 0.6}), Vector3(1.0, -1.0, 1.0)), Vector3(0.1, -0.2, 0.3));
  EXPECT_TRUE(SupportPoint(ShapeOf(ShapeType::kSphere, {0.5, 0.0, 0.0}), slanted).isApprox(0.5 * slanted.normalized()));
  const Vector3 rim = SupportPoint(ShapeOf(ShapeType::kCylinder, {0.5, 2.0, 0.0}), slanted);
  EXPECT_TRUE(rim.isApprox(Vector3(0.5, 0.0, -1.0)));
  const Vector3 cap = SupportPoint(ShapeOf(ShapeType::kCapsule, {0.5, 2.0, 0.0}), slanted);
  EXPECT_TRUE(cap.isApprox(Vector3(0.0, 0.0, -1.0) + 0.5 * slanted.normalized()));
  Shape mesh = ShapeOf(ShapeType::kMesh, Vector3::Zero());
  EXPECT_EQ(SupportPoint(mesh, slanted), Vector3(0.0, 0.0, 0.0));
  mesh.vertices = {{0.0, 0.0, 1.0}, {1.0, 2.0, -3.0}, {1.0, 0.0, 1.0}};
  EXPECT_EQ(SupportPoint(mesh, slanted), mesh.vertices[1]);
}

/// No point of a shape is farther along a direction than its support point, or farther from its middle than its radius.
TEST(ShapeExtent, NothingLiesBeyond) {
  for (const ShapeType type : {ShapeType::kBox, ShapeType::kSphere, ShapeType::kCylinder, ShapeType::kCapsule}) {
    const Shape shape = ShapeOf(type, {0.3, 0.7, 0.2});
    for (int k = 0; k < 200; ++k) {
      const Vector3 d(std::sin(0.7 * k), std::cos(1.3 * k), std::sin(2.1 * k + 0.5));
      const Vector3 farthest = SupportPoint(shape, d);
      EXPECT_LE(farthest.norm(), BoundingRadius(shape) + 1e-12);
      for (int other = 0; other < 200; ++other) {
        const Vector3 e(std::sin(1.1 * other), std::sin(0.3 * other + 0.2), std::cos(0.9 * other));
        EXPECT_LE(SupportPoint(shape, e).dot(d), farthest.dot(d) + 1e-12);
      }
    }
  }
}

/// A foot at the end of a shank. The shank belongs to the foot only if it reaches as low.
TEST(ShapeExtent, AShankIsOfItsFootOnlyWhereItReachesAsLow) {
  const std::string feet = "feet: [{link: A_foot}, {link: B_foot}, {link: C_foot}, {link: D_foot}]";
  for (const bool low : {false, true}) {
    const std::string box = low ? "<box size='0.02 0.02 0.45'/>" : "<box size='0.02 0.02 0.3'/>";
    const Result<RobotModel> model =
        LoadRobotFromText(Replaced(FourLegs(), SmallLink("A_shank"), SmallLink("A_shank", box)), feet);
    ASSERT_TRUE(model.ok()) << model.failure().message;
    std::vector<std::string> of_feet;
    for (const Shape& shape : model->collision_shapes)
      if (IsShapeOfAFoot(*model, shape)) of_feet.push_back(shape.link);
    std::sort(of_feet.begin(), of_feet.end());
    std::vector<std::string> expected = {"A_foot", "B_foot", "C_foot", "D_foot"};
    if (low) expected.insert(expected.begin() + 1, "A_shank");
    EXPECT_EQ(of_feet, expected);
  }
}

}  // namespace
}  // namespace gaitwright
