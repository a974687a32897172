// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "kinematics/model/body_tree.h"
#include "kinematics/model/robot_yaml.h"
#include "kinematics/model/urdf_check.h"
#include "kinematics/spatial/rotation.h"
#include "tests/kinematics/description/mjcf_texts.h"

namespace gaitwright {
namespace {

/// Three joints in series, 'a', 'b' and 'c', and these sections.
std::string Chain(const std::string& sections, const std::string& a = "", const std::string& b = "") {
  const std::string end = MjcfBodyOf("three", "<joint name='c'/>");
  const std::string middle = MjcfBodyOf("two", "<joint name='b' axis='0 1 0' " + b + "/>" + end, "pos='0 0 -1'");
  return MjcfOf(MjcfBodyOf("one", "<joint name='a' " + a + "/>" + middle), "<compiler angle='radian'/>" + sections);
}

std::string Equal(const std::string& attributes) { return "<equality><joint name='e' " + attributes + "/></equality>"; }

/// The joint of that name, which may follow another one.
Joint AnyJoint(const ConvertedMjcf& converted, const std::string& name) {
  for (const Joint& joint : TreeOf(converted).joints) {
    if (joint.name == name) return joint;
  }
  ADD_FAILURE() << "no joint " << name;
  return {};
}

TEST(MjcfEquality, OfJointsIsAMimic) {
  // a - 0.2 = 0.1 + 2 (b - 0.3)
  const ConvertedMjcf converted =
      Converted(Chain(Equal("joint1='a' joint2='b' polycoef='0.1 2 0 0 0'"), "ref='0.2'", "ref='0.3'"));
  EXPECT_FALSE(CheckUrdf(converted.urdf));
  const Joint joint = AnyJoint(converted, "a");
  EXPECT_TRUE(joint.is_mimic);
  EXPECT_DOUBLE_EQ(joint.multiplier, 2.0);
  EXPECT_NEAR(joint.offset, 0.2 + 0.1 - 2.0 * 0.3, 1e-12);
  EXPECT_DOUBLE_EQ(AnyJoint(Converted(Chain(Equal("joint1='a' joint2='b'"))), "a").multiplier, 1.0);
  EXPECT_DOUBLE_EQ(AnyJoint(Converted(Chain(Equal("joint1='a' joint2='b' polycoef='0.5'"))), "a").offset, 0.5);
}

TEST(MjcfEquality, TheJointWithAnActuatorLeads) {
  const ConvertedMjcf converted = Converted(Chain(Equal("joint1='a' joint2='b' polycoef='0.1 2'") +
                                                  "<actuator><motor joint='a' ctrlrange='-3 3'/></actuator>"));
  const Joint joint = AnyJoint(converted, "b");
  EXPECT_TRUE(joint.is_mimic);
  EXPECT_DOUBLE_EQ(joint.multiplier, 0.5);
  EXPECT_DOUBLE_EQ(joint.offset, -0.05);
  EXPECT_DOUBLE_EQ(AnyJoint(converted, "a").effort_limit, 3.0);
}

TEST(MjcfEquality, WithoutASecondJointHoldsTheFirstStill) {
  const std::string sections =
      "<equality><joint name='e' joint1='b' polycoef='0.3'/><joint joint1='c' joint2='b' polycoef='0.1 2'/></equality>";
  const ConvertedMjcf converted = Converted(Chain(sections, "", "ref='0.2'"));
  const RobotModel model = TreeOf(converted);
  ASSERT_EQ(model.num_dofs(), 1);  // b is locked at 0.5, and so is c, which follows it
  ExpectNote(converted, {"joint 'e'", "'b' is locked at 0.5"});
  const Frame& two = model.frames[static_cast<std::size_t>(model.FrameIndex("two"))];
  EXPECT_LT((two.X_BF.linear() - RotationExp({0, 0.3, 0})).norm(), 1e-12);
  EXPECT_LT((two.X_BF.translation() - Vector3(0, 0, -1)).norm(), 1e-12);
  const Frame& three = model.frames[static_cast<std::size_t>(model.FrameIndex("three"))];
  EXPECT_LT((three.X_BF.linear() - RotationExp({0, 0.3, 0}) * RotationExp({0, 0, 0.1 + 2.0 * 0.3})).norm(), 1e-12);
}

TEST(MjcfEquality, RefusesLoopsAndWhatIsNotLinear) {
  const auto with = [](const std::string& sections) { return MjcfMessage(Chain(sections)); };
  ExpectSays(with("<equality>\n<connect name='e' body1='three' body2='base' anchor='0 0 0'/></equality>"),
             {"model.xml, line 3: connect 'e'", "closes a loop"});
  ExpectSays(with("<equality><weld name='e' body1='three'/></equality>"), {"weld 'e'", "to the world"});
  ExpectSays(with("<equality><connect site1='p' site2='q'/></equality>"), {"<connect>", "site1 'p' does not exist"});
  ExpectSays(with("<equality><connect name='e' body1='three' body2='bass'/></equality>"),
             {"'bass'", "nearest is 'base'"});
  ExpectSays(with("<equality><tendon name='e' tendon1='t'/></equality>"), {"tendon 'e'", "not supported"});
  ExpectSays(with(Equal("joint1='a' joint2='b' polycoef='0 1 0.5 0 0'")), {"joint 'e'", "only linear"});
  ExpectSays(with(Equal("joint1='a' joint2='b' polycoef='0 1e-9 0 0 0'")), {"joint 'e'", "1e-09"});
  ExpectSays(with(Equal("joint1='a' joint2='x'")), {"joint 'e'", "joint2 'x' does not exist"});
  ExpectSays(with(Equal("joint2='a'")), {"joint 'e'", "no 'joint1'"});
  ExpectSays(with(Equal("joint1='a' joint2='a'")), {"joint 'e'", "to itself"});
  const std::string circle =
      "<equality><joint joint1='a' joint2='b'/><joint joint1='b' joint2='c'/><joint name='e' joint1='c' "
      "joint2='a'/></equality>";
  ExpectSays(with(circle), {"joint 'e'", "in a cycle"});
  const std::string twice =
      "<equality><joint joint1='a' joint2='b'/><joint joint1='c' joint2='b'/><joint name='e' joint1='a' "
      "joint2='c'/></equality>";
  ExpectSays(with(twice), {"joint 'e'", "already coupled by another equality"});
}

TEST(MjcfEquality, PassesOverWhatIsNotActiveOrNotTheRobots) {
  ExpectNote(Converted(Chain("<equality><weld name='e' body1='three' active='false'/></equality>")),
             {"weld 'e'", "not active"});
  const std::string other = Replaced(Chain("<equality><weld name='e' body1='box'/></equality>"), "</worldbody>",
                                     "<body name='box'><freejoint/><geom size='1'/></body></worldbody>");
  ExpectNote(Converted(other), {"weld 'e'", "not part of the robot"});
}

TEST(MjcfKeyframe, HomeIsTheStandingPosture) {
  const std::string keys =
      "<keyframe><key name='lie' qpos='0 0 0 1 0 0 0 9 9 9'/>\n<key name='home' qpos='0 0 1 1 0 0 0 0.1 0.2 "
      "0.3'/></keyframe>";
  const ConvertedMjcf converted = Converted(Chain(keys));
  const RobotYaml yaml = ParseRobotYaml(converted.yaml);
  ASSERT_EQ(yaml.standing.size(), 3U);
  EXPECT_EQ(yaml.standing[1].joint, "b");
  EXPECT_EQ(yaml.standing[1].position, 0.2);
  ExpectNote(converted, {"line 3: key 'home'", "standing posture"});
  const RobotYaml first = ParseRobotYaml(Converted(Chain(Replaced(keys, "home", "other"))).yaml);
  EXPECT_EQ(first.standing.at(1).position, 9.0);
}

TEST(MjcfKeyframe, LeavesOutFollowersAndWhatIsOutOfRange) {
  const std::string keys =
      "<keyframe><key name='home' qpos='0 0 0 1 0 0 0 0.1 0.50001 0.3'/></keyframe>" + Equal("joint1='a' joint2='c'");
  const RobotYaml yaml = ParseRobotYaml(Converted(Chain(keys, "", "range='-0.5 0.5'")).yaml);
  ASSERT_EQ(yaml.standing.size(), 2U);
  EXPECT_EQ(yaml.standing[0].joint, "b");
  EXPECT_EQ(yaml.standing[0].position, 0.5);  // beyond its range by rounding
  EXPECT_EQ(yaml.standing[1].joint, "c");
  const ConvertedMjcf narrow = Converted(Chain(keys, "range='-0.2 0.2'", "range='-0.1 0.1'"));
  EXPECT_TRUE(ParseRobotYaml(narrow.yaml).standing.empty());
  ExpectNote(narrow, {"key 'home'", "0.50001 of joint 'b' is outside"});
  ExpectNote(narrow, {"key 'home'", "0.3 of joint 'c' is outside"});  // of its follower
}

TEST(MjcfKeyframe, CountsTheJointsOfAllBodies) {
  const std::string box = "<body name='box'><freejoint/><geom size='1'/></body>";
  const std::string keys = "<keyframe><key name='home' qpos='BOX 0 0 0 1 0 0 0 0.1 0.2 0.3'/></keyframe>";
  const std::string before = Replaced(Chain(keys), "<worldbody>", "<worldbody>" + box);
  EXPECT_EQ(ParseRobotYaml(Converted(Replaced(before, "BOX", "1 2 3 1 0 0 0")).yaml).standing.at(2).position, 0.3);
  const ConvertedMjcf wrong = Converted(Replaced(before, "BOX", ""));
  EXPECT_TRUE(ParseRobotYaml(wrong.yaml).standing.empty());
  ExpectNote(wrong, {"key 'home'", "10 numbers, but the joints need 17"});
}

TEST(MjcfKeyframe, GivesABallJointItsThreeTurns) {
  const std::string keys = "<keyframe><key qpos='0 0 0 1 0 0 0 1 1 0 0 0.2 0.3'/></keyframe>";
  const RobotYaml yaml = ParseRobotYaml(Converted(Chain(keys, "type='ball'")).yaml);
  ASSERT_EQ(yaml.standing.size(), 5U);
  EXPECT_EQ(yaml.standing[0].joint, "a_x");
  EXPECT_NEAR(yaml.standing[0].position, 1.5707963267948966, 1e-12);
  EXPECT_NEAR(yaml.standing[2].position, 0.0, 1e-12);
}

}  // namespace
}  // namespace gaitwright
