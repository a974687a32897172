// SPDX-License-Identifier: BSD-3-Clause
// Legs, and other limbs that reach as low.
#include <gtest/gtest.h>

#include "kinematics/model/derive_legs.h"
#include "tests/kinematics/model/small_urdf.h"

namespace gaitwright {
namespace {

/// An arm of four joints on the trunk that reaches below the feet, with a gripper of two fingers.
std::string LongArm() {
  std::string text;
  std::string parent = "trunk", at = "0.1 0 0.05";
  for (const std::string part : {"arm1", "arm2", "arm3", "arm4"}) {
    text += SmallLink(part) + PitchJoint(part + "_joint", parent, part, at);
    parent = part;
    at = "0 0 0.2";
  }
  for (const std::string finger : {"finger1", "finger2"})
    text +=
        SmallLink(finger, "<box size='0.02 0.02 0.05'/>") + PitchJoint(finger + "_joint", "arm4", finger, "0 0 0.1");
  return text;
}

TEST(Legs, AnArmThatReachesTheGroundIsNone) {
  const Result<RobotModel> model = LoadRobotFromText(Replaced(FourLegs(), "</robot>", LongArm() + "</robot>"), "");
  ASSERT_TRUE(model.ok()) << model.failure().message;
  ASSERT_EQ(model->legs.size(), 4U);
  for (const Leg& leg : model->legs) EXPECT_EQ(leg.joints.size(), 2U);
}

TEST(Legs, AFootOfTwoToesIsOneLeg) {
  std::string toes;
  for (const std::string leg : {"A", "B", "C", "D"}) {
    for (const std::string toe : {"_toe1", "_toe2"})
      toes += SmallLink(leg + toe, "<sphere radius='0.01'/>") +
              PitchJoint(leg + toe + "_joint", leg + "_ankle", leg + toe,
                         toe == "_toe1" ? "0.03 0 -0.05" : "-0.03 0 -0.05");
    toes += SmallLink(leg + "_ankle") + PitchJoint(leg + "_ankle_joint", leg + "_shank", leg + "_ankle", "0 0 -0.22");
  }
  const Result<RobotModel> model = LoadRobotFromText(Replaced(FourLegs(), "</robot>", toes + "</robot>"), "");
  ASSERT_TRUE(model.ok()) << model.failure().message;
  EXPECT_EQ(model->legs.size(), 4U);
}

TEST(Legs, AWheelIsAFootOfItsRadius) {
  std::string urdf = FourLegs("<cylinder radius='0.06' length='0.03'/>");
  for (const std::string leg : {"A", "B", "C", "D"}) {
    const std::string fixed = "<joint name='" + leg + "_end' type='fixed'>";
    urdf = Replaced(urdf, fixed, "<joint name='" + leg + "_end' type='continuous'><axis xyz='0 0 1'/>");
  }
  const Result<RobotModel> model = LoadRobotFromText(urdf, "");
  ASSERT_TRUE(model.ok()) << model.failure().message;
  for (const Foot& foot : model->feet) {
    EXPECT_EQ(foot.type, FootType::kSphere);
    EXPECT_NEAR(foot.radius, 0.06, 1e-9);
    EXPECT_LT(foot.X_BF.translation().norm(), 1e-9) << "about its axle";
  }
}

TEST(Legs, AFootWithoutCollisionGeometryStandsOnWhatIsSeen) {
  const std::string seen = Replaced(FourLegs(), "<collision><geometry><sphere radius='0.02'/></geometry></collision>",
                                    "<visual><geometry><sphere radius='0.02'/></geometry></visual>");
  const Result<RobotModel> model = LoadRobotFromText(seen, "");
  ASSERT_TRUE(model.ok()) << model.failure().message;
  for (const Foot& foot : model->feet) EXPECT_DOUBLE_EQ(foot.radius, 0.02);
  EXPECT_EQ(model->findings.size(), 4U);
  EXPECT_EQ(model->findings.front().code, FailureCode::kVisualFoot);
}

TEST(Legs, AJointThatMovesNothingIsFixed) {
  const std::string spin =
      "<link name='w'/><joint name='spin' type='continuous'><parent link='A_shank'/><child link='w'/><axis xyz='1 0 "
      "0'/></joint>";
  const Result<RobotModel> model = LoadRobotFromText(Replaced(FourLegs(), "</robot>", spin + "</robot>"), "");
  ASSERT_TRUE(model.ok()) << model.failure().message;
  EXPECT_EQ(model->num_dofs(), 8);
  ASSERT_EQ(model->findings.size(), 1U);
  EXPECT_EQ(PartText(model->findings.front().part), "joint 'spin'");
  const std::string text = Replaced(FourLegs(), "</robot>", spin + "</robot>");
  EXPECT_EQ(MessageOf(text, "standing: {spin: 0.1}\n"), "") << "what is said of it is not missed";
}

/// Two legs of three joints below a waist, and arms of two joints, straight out to both sides.
std::string LegsBelowAWaist() {
  std::string text = "<robot name='waist'>" + SmallLink("trunk") + SmallLink("pelvis", "<box size='0.1 0.2 0.05'/>");
  text += Replaced(PitchJoint("waist", "trunk", "pelvis", "0 0 -0.1"), "0 1 0", "0 0 1");
  for (const std::string side : {"left", "right"}) {
    const std::string y = side == "left" ? "" : "-";
    std::string parent = "pelvis", at = "0 " + y + "0.1 0";
    for (const std::string part : {"_thigh", "_shank", "_foot"}) {
      text += SmallLink(side + part, part == "_foot" ? "<box size='0.2 0.1 0.04'/>" : "");
      text += PitchJoint(side + part + "_joint", parent, side + part, at);
      parent = side + part;
      at = "0 0 -0.3";
    }
    parent = "trunk";
    at = "0 " + y + "0.15 0.3";
    for (const std::string part : {"_upper", "_lower"}) {
      text += SmallLink(side + part, "<box size='0.04 0.04 0.04'/>");
      text += Replaced(PitchJoint(side + part + "_joint", parent, side + part, at), "0 1 0", "1 0 0");
      parent = side + part;
      at = "0 " + y + "0.3 0";
    }
  }
  return text + "</robot>";
}

TEST(Legs, BelowAWaistAreNoneTheLess) {
  const Result<RobotModel> model = LoadRobotFromText(LegsBelowAWaist(), "");
  ASSERT_TRUE(model.ok()) << model.failure().message;
  ASSERT_EQ(model->legs.size(), 2U);
  EXPECT_EQ(model->feet[0].link, "left_foot");
  EXPECT_EQ(model->feet[1].link, "right_foot");
  for (const Leg& leg : model->legs) EXPECT_EQ(leg.joints.size(), 4U);
}

}  // namespace
}  // namespace gaitwright
