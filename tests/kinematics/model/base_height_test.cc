// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/base_height.h"

#include "tests/kinematics/model/small_urdf.h"

namespace gaitwright {
namespace {

/// Four legs whose root is a link without mass at a height above the trunk [m]; negative values are below it.
RobotModel FourLegsOfRoot(double height_m) {
  const std::string root =
      "<link name='root'/><joint name='mount' type='fixed'><parent link='root'/><child link='trunk'/><origin xyz='0 "
      "0 " +
      std::to_string(-height_m) + "'/></joint></robot>";
  return LoadRobotFromText(Replaced(FourLegs(), "</robot>", root), "").value();
}

TEST(BaseHeight, TheHipsTellItWhereTheyAreHigherThanTheOrigin) {
  EXPECT_EQ(HeightPoint(FourLegsOfRoot(0.0)), Vector3::Zero());
  EXPECT_EQ(HeightPoint(FourLegsOfRoot(0.3)), Vector3::Zero());
  EXPECT_NEAR(HipsOverOrigin(FourLegsOfRoot(0.3)), -0.3, 1e-12);
  EXPECT_TRUE(HeightPoint(FourLegsOfRoot(-0.3)).isApprox(Vector3(0.0, 0.0, 0.3)));
}

TEST(BaseHeight, WhereTheRootLinkHasItsOriginIsNoDifference) {
  const RobotModel trunk = FourLegsOfRoot(0.0);
  for (const double below_m : {0.1, 0.35, 0.41, 0.8}) {  // a base_footprint at the ground or under it
    const RobotModel model = FourLegsOfRoot(-below_m);
    ASSERT_EQ(model.legs.size(), trunk.legs.size()) << below_m;
    EXPECT_TRUE(model.standing_joints.isApprox(trunk.standing_joints, 1e-6)) << below_m;
    EXPECT_NEAR(model.standing_base_height_m, trunk.standing_base_height_m - below_m, 1e-6);
    for (const double share : {1.0, 0.85, 0.5})
      EXPECT_NEAR(BaseHeightAtShare(model, share) + below_m, BaseHeightAtShare(trunk, share), 1e-6);
  }
}

TEST(BaseHeight, ArmsOfABustOnAHighMountAreNoLegs) {
  const std::string torso = SmallLink("torso", "<box size='0.2 0.3 0.5'/>");
  std::string urdf = "<robot name='bust'><link name='base_footprint'/>" + torso +
                     "<joint name='mount' type='fixed'><parent link='base_footprint'/><child link='torso'/><origin "
                     "xyz='0 0 0.8'/></joint>";
  for (const std::string side : {"L", "R"}) {
    urdf += SmallLink(side + "_upper") + SmallLink(side + "_fore", "<box size='0.05 0.05 0.3'/>") +
            PitchJoint(side + "_shoulder", "torso", side + "_upper", side == "L" ? "0 0.2 0.2" : "0 -0.2 0.2") +
            PitchJoint(side + "_elbow", side + "_upper", side + "_fore", "0 0 -0.3");
  }
  ExpectSays(MessageOf(urdf + "</robot>"), {"0 legs found"});
}

}  // namespace
}  // namespace gaitwright
