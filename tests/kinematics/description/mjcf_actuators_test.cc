// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/description/mjcf_actuators_internal.h"
#include "kinematics/model/passive_joints.h"
#include "kinematics/model/robot_yaml.h"
#include "tests/kinematics/description/mjcf_texts.h"

namespace gaitwright {
namespace {

/// A body with two joints in series, 'j' and 'k', and these actuators.
std::string Driven(const std::string& actuators, const std::string& joint = "", const std::string& sections = "") {
  return MjcfOf(MjcfBodyOf("thigh", "<joint name='j' " + joint + "/>" + MjcfBodyOf("shank", "<joint name='k'/>")),
                sections + "<actuator>" + actuators + "<motor name='of_k' joint='k' ctrlrange='-1 1'/></actuator>");
}

/// The effort of a joint; 0 if it is unknown.
double EffortOf(const std::string& actuators, const std::string& joint = "", const std::string& sections = "") {
  const Joint of = JointNamed(TreeOf(Converted(Driven(actuators, joint, sections))), "j");
  return of.effort_limit_is_placeholder ? 0.0 : of.effort_limit;
}

RobotYaml YamlOf(const std::string& actuators, const std::string& joint = "") {
  return ParseRobotYaml(Converted(Driven(actuators, joint)).yaml);
}

TEST(MjcfActuators, EffortIsGearTimesTheForceRange) {
  EXPECT_DOUBLE_EQ(EffortOf("<motor joint='j' gear='-5' forcerange='-3 3'/>"), 15.0);
  EXPECT_DOUBLE_EQ(EffortOf("<position joint='j' kp='100' forcerange='-30 30'/>"), 30.0);
  EXPECT_DOUBLE_EQ(EffortOf("<velocity joint='j' gear='2' forcerange='-30 30'/>"), 60.0);
  EXPECT_DOUBLE_EQ(EffortOf("<general joint='j' gear='2' forcerange='-30 30' gaintype='affine'/>"), 60.0);
  EXPECT_DOUBLE_EQ(EffortOf("<motor jointinparent='j' forcerange='-3 3'/>"), 3.0);
}

TEST(MjcfActuators, OfAMotorControlTimesGainBoundsForceToo) {
  EXPECT_DOUBLE_EQ(EffortOf("<motor joint='j' gear='5' ctrlrange='-2 2'/>"), 10.0);
  EXPECT_DOUBLE_EQ(EffortOf("<motor joint='j' gear='5' ctrlrange='-2 2' forcerange='-1 1'/>"), 5.0);
  EXPECT_DOUBLE_EQ(EffortOf("<general joint='j' gainprm='30' ctrlrange='-2 2'/>"), 60.0);
  EXPECT_DOUBLE_EQ(EffortOf("<general joint='j' gainprm='30' ctrlrange='-2 2' dyntype='filter'/>"), 60.0);
  // The control of a servo is not a force.
  EXPECT_DOUBLE_EQ(EffortOf("<position joint='j' ctrlrange='-2 2'/>"), 0.0);
  EXPECT_DOUBLE_EQ(EffortOf("<general joint='j' ctrlrange='-2 2' dyntype='integrator'/>"), 0.0);
}

TEST(MjcfActuators, RangesCountAsTheirFlagsSay) {
  EXPECT_DOUBLE_EQ(EffortOf("<motor joint='j' forcerange='-3 3' forcelimited='false'/>"), 0.0);
  EXPECT_DOUBLE_EQ(EffortOf("<motor joint='j' forcerange='-3 3'/>", "", "<compiler autolimits='false'/>"), 0.0);
  EXPECT_DOUBLE_EQ(
      EffortOf("<motor joint='j' forcerange='-3 3' forcelimited='true'/>", "", "<compiler autolimits='false'/>"), 3.0);
  ExpectSays(MjcfMessage(Driven("<motor name='m' joint='j' forcelimited='true'/>")),
             {"motor 'm'", "limited, but 'forcerange' is missing"});
  ExpectSays(MjcfMessage(Driven("<motor name='m' joint='j' ctrlrange='2 1'/>")), {"motor 'm'", "the lower end 2"});
}

TEST(MjcfActuators, AddUpAndStayBelowTheJointsOwnLimit) {
  const std::string two = "<motor joint='j' forcerange='-3 3'/><motor joint='j' gear='2' forcerange='-4 4'/>";
  EXPECT_DOUBLE_EQ(EffortOf(two), 11.0);
  EXPECT_DOUBLE_EQ(EffortOf(two, "actuatorfrcrange='-7 7'"), 7.0);
  EXPECT_DOUBLE_EQ(EffortOf(two, "actuatorfrcrange='-7 7' actuatorfrclimited='false'"), 11.0);
  EXPECT_DOUBLE_EQ(EffortOf("<motor joint='j'/>", "actuatorfrcrange='-7 7'"), 7.0);
}

TEST(MjcfActuators, OfDifferentSidesTheWeakerOneCountsAndIsNoted) {
  const ConvertedMjcf converted = Converted(Driven("<motor name='m' joint='j' forcerange='-3 5'/>"));
  EXPECT_DOUBLE_EQ(JointNamed(TreeOf(converted), "j").effort_limit, 3.0);
  ExpectNote(converted, {"motor 'm'", "'forcerange' is '-3 5'", "3 is used"});
  EXPECT_DOUBLE_EQ(EffortOf("<motor joint='j' forcerange='0 5'/>"), 5.0);
}

TEST(MjcfActuators, AJointWithoutLimitHasAnUnknownOne) {
  const ConvertedMjcf converted = Converted(Driven("<motor joint='j'/>"));
  EXPECT_TRUE(JointNamed(TreeOf(converted), "j").effort_limit_is_placeholder);
  EXPECT_FALSE(JointNamed(TreeOf(converted), "k").effort_limit_is_placeholder);
  EXPECT_TRUE(JointNamed(TreeOf(converted), "k").velocity_limit_is_placeholder);
  ExpectNote(converted, {"joint 'j'", "no force limit"});
}

TEST(MjcfActuators, AJointWithoutActuatorHasNoMotorAndOneWithoutLimitHas) {
  const ConvertedMjcf converted = Converted(Driven(""));
  const RobotModel model = TreeOf(converted);
  EXPECT_EQ(JointNamed(model, "j").effort_limit, 0.0);
  EXPECT_TRUE(IsPassive(model, model.DofIndex("j")));
  EXPECT_FALSE(IsPassive(model, model.DofIndex("k")));
  ExpectNote(converted, {"joint 'j'", "no actuator", "limits: {'j': {effort_nm: ...}}"});
  const RobotModel driven = TreeOf(Converted(Driven("<position joint='j' kp='50'/>")));
  EXPECT_FALSE(IsPassive(driven, driven.DofIndex("j")));
}

TEST(MjcfActuators, WithoutActuatorsTheJointsOwnLimitsAreTheKnownOnes) {
  const RobotModel model = TreeOf(Converted(MjcfOf(
      MjcfBodyOf("thigh", "<joint name='j'/>" + MjcfBodyOf("shank", "<joint name='k' actuatorfrcrange='-9 9'/>")))));
  EXPECT_EQ(model.dof_effort_limit(model.DofIndex("k")), 9.0);
  EXPECT_FALSE(IsPassive(model, model.DofIndex("j")));
}

TEST(MjcfActuators, WithoutAnyActuatorAllLimitsAreUnknown) {
  const ConvertedMjcf converted = Converted(MjcfOf(MjcfBodyOf("leg", "<joint name='j'/>")));
  EXPECT_TRUE(JointNamed(TreeOf(converted), "j").effort_limit_is_placeholder);
  ExpectNote(converted, {"no joint actuators"});
}

TEST(MjcfActuators, GainsOfServosAreThoseOfTheJoint) {
  const RobotYaml position = YamlOf("<position joint='j' kp='10' kv='2' gear='3'/>");
  ASSERT_EQ(position.gains.size(), 1U);
  EXPECT_DOUBLE_EQ(position.gains[0].stiffness.value(), 90.0);
  EXPECT_DOUBLE_EQ(position.gains[0].damping.value(), 18.0);
  const RobotYaml velocity = YamlOf("<velocity joint='j' kv='2'/>", "type='slide'");
  ASSERT_EQ(velocity.gains.size(), 1U);
  EXPECT_TRUE(velocity.gains[0].sliding);
  EXPECT_FALSE(velocity.gains[0].stiffness.has_value());
  EXPECT_DOUBLE_EQ(velocity.gains[0].damping.value(), 2.0);
  const RobotYaml general = YamlOf("<general joint='j' gainprm='55' biastype='affine' biasprm='0 -55 -4'/>");
  ASSERT_EQ(general.gains.size(), 1U);
  EXPECT_DOUBLE_EQ(general.gains[0].stiffness.value(), 55.0);
  EXPECT_DOUBLE_EQ(general.gains[0].damping.value(), 4.0);
  EXPECT_TRUE(YamlOf("<motor joint='j'/>").gains.empty());
}

TEST(MjcfActuators, ArmatureIsTheRotorsInertia) {
  const RobotYaml yaml = YamlOf("", "armature='0.02' damping='0.3' frictionloss='0.1'");
  ASSERT_EQ(yaml.motors.size(), 1U);
  EXPECT_EQ(yaml.motors[0].joint, "j");
  EXPECT_EQ(yaml.motors[0].rotor_inertia.value(), 0.02);
  EXPECT_TRUE(YamlOf("", "type='slide' armature='2'").motors.at(0).sliding);
  const RobotYaml ball = YamlOf("", "type='ball' armature='0.02'");
  ASSERT_EQ(ball.motors.size(), 3U);
  EXPECT_EQ(ball.motors[2].joint, "j_z");
  const Joint joint =
      JointNamed(TreeOf(Converted(Driven("", "armature='0.02' damping='0.3' frictionloss='0.1'"))), "j");
  EXPECT_EQ(joint.damping, 0.3);
  EXPECT_EQ(joint.friction, 0.1);
}

TEST(MjcfActuators, LargeEffortsAreKnownOnes) {
  const RobotYaml yaml = YamlOf("<motor joint='j' forcerange='-1500 1500'/>");
  ASSERT_EQ(yaml.limits.size(), 1U);
  EXPECT_EQ(yaml.limits[0].effort.value(), 1500.0);
}

TEST(MjcfActuators, OfABallJointTheWeakestAxisCounts) {
  const std::string three =
      "<motor joint='j' gear='1 0 0' forcerange='-3 3'/><motor joint='j' gear='0 2 0' forcerange='-1 1'/>"
      "<motor joint='j' gear='0 0 1' forcerange='-5 5'/>";
  const ConvertedMjcf converted = Converted(Driven(three, "type='ball'"));
  EXPECT_EQ(JointNamed(TreeOf(converted), "j_z").effort_limit, 2.0);
  ExpectNote(converted, {"joint 'j'", "differ by axis"});
}

TEST(MjcfActuators, RefusesOrNotesWhatDrivesNoJoint) {
  const auto message = [](const std::string& actuators) { return MjcfMessage(Driven(actuators)); };
  ExpectNote(Converted(Driven("<motor name='m' tendon='t'/>")),
             {"model.xml, line 2: motor 'm'", "'t' by 'tendon'", "left out"});
  ExpectNote(Converted(Driven("<motor name='m' cranksite='s'/>")), {"motor 'm'", "'s' by 'cranksite'"});
  ExpectSays(message("<motor name='m' joint='jj'/>"), {"motor 'm'", "no joint 'jj'", "nearest is 'j'"});
  ExpectNote(Converted(Driven("<motor name='m' site='s'/>")), {"motor 'm'", "drives no joint; it is left out"});
  ExpectNote(Converted(Driven("<adhesion name='m' body='b'/>")), {"adhesion 'm'", "left out"});
  ExpectNote(Converted(Driven("<engine name='m' joint='j'/>")), {"engine 'm'", "unknown"});
}

/// The driven joints 'j' and 'k', and the joint 'p', which a tendon ties to them.
std::string WithTendon(const std::string& attributes) {
  const std::string joints = MjcfBodyOf("thigh", "<joint name='j'/>" + MjcfBodyOf("shank", "<joint name='k'/>")) +
                             MjcfBodyOf("waist", "<joint name='p'/>");
  return MjcfOf(
      joints,
      "<actuator><motor joint='j' ctrlrange='-6 6'/><motor joint='k' ctrlrange='-8 8'/></actuator><tendon><fixed "
      "name='t' " +
          attributes + "><joint joint='j' coef='0.5'/><joint joint='k' coef='-0.5'/><joint joint='p' coef='2'/>" +
          "</fixed></tendon>");
}

TEST(MjcfActuators, ATendonThatIsHeldCarriesTorqueOn) {
  const ConvertedMjcf tied = Converted(WithTendon("range='-0.01 0.01'"));
  EXPECT_DOUBLE_EQ(JointNamed(TreeOf(tied), "p").effort_limit, 2.0 * 6.0 / 0.5);
  ExpectNote(tied, {"fixed 't'", "of motor torque to joint 'p'"});
  for (const char* loose : {"", "range='-1 1'", "range='-0.01 0.01' limited='false'"})
    EXPECT_EQ(JointNamed(TreeOf(Converted(WithTendon(loose))), "p").effort_limit, 0.0) << loose;
}

}  // namespace
}  // namespace gaitwright
