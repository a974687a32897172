// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "kinematics/model/robot_yaml.h"
#include "tests/kinematics/description/mjcf_texts.h"

namespace gaitwright {
namespace {

ConvertedMjcf WithLeg(const std::string& joint, const std::string& sections = "") {
  return Converted(MjcfOf(MjcfBodyOf("leg", joint), sections));
}
std::string MessageOfLeg(const std::string& inside, const std::string& sections = "") {
  return MjcfMessage(MjcfOf(MjcfBodyOf("leg", inside), sections));
}

TEST(MjcfRefusals, NameElementAndLine) {
  for (const std::string tag : {"replicate", "attach", "composite", "flexcomp"})
    ExpectSays(MessageOfLeg("<" + tag + "/>"), {"model.xml, line 9: <" + tag + ">", "not supported"});
  ExpectSays(MessageOfLeg("<joint name='j' type='screw'/>"), {"line 9: joint 'j'", "'type' is 'screw'", "'hinge'"});
  ExpectSays(MessageOfLeg("<joint name='j' axis='0 0 0'/>"), {"joint 'j'", "its axis is zero"});
  ExpectSays(MessageOfLeg("<joint name='j' damping='-1'/>"), {"joint 'j'", "damping is -1"});
  ExpectSays(MessageOfLeg("<joint name='j' range='1 -1'/>"), {"joint 'j'", "the lower end 1", "-1"});
  ExpectSays(MessageOfLeg("<joint name='j' limited='true'/>"), {"joint 'j'", "limited, but 'range' is missing"});
  ExpectSays(MessageOfLeg("<joint name='j' limited='maybe'/>"), {"joint 'j'", "'limited' is 'maybe'", "'auto'"});
  ExpectSays(MessageOfLeg("<joint name='j' range='1e99 2'/>"), {"joint 'j'", "1e99 is too large"});
  ExpectSays(MessageOfLeg("<joint name='j' type='free'/>"), {"joint 'j'", "body 'leg' has a free joint"});
  ExpectSays(MessageOfLeg("<joint name='j'/>\n<joint name='j'/>"), {"line 10: joint 'j'", "two joints"});
  ExpectSays(MessageOfLeg("<body name='leg'/>"), {"line 9: body 'leg'", "two bodies"});
  ExpectSays(MessageOfLeg("<body name='&#1;'/>"), {"line 9: <body>", "'name' is not valid UTF-8"});
  ExpectSays(MessageOfLeg(fmt::format("<body name='{}'/>", std::string(501, 'a'))), {"'name' has 501 bytes"});
  ExpectSays(MjcfMessage(MjcfOf("<joint name='j'/>")), {"body 'base'", "free joint as well as other joints"});
  ExpectSays(MjcfMessage("<mujoco><worldbody>\n<joint/></worldbody></mujoco>"),
             {"line 2: <joint>", "cannot have a joint"});
}

TEST(MjcfRefusals, OfAWorldThatIsOnlyFurnishedThereAreNone) {
  const std::string text = Replaced(MjcfOf(""), "<worldbody>",
                                    "<worldbody><geom type='plane' size='1 1 1'/><light/><camera/><site/>"
                                    "<replicate count='3'><geom size='1'/></replicate><body mocap='true'/>");
  ExpectNote(Converted(text), {"<replicate>", "not part of the robot"});
  ExpectSays(MjcfMessage(Replaced(text, "<geom size='1'/>", "<frame><body/></frame>")),
             {"<replicate>", "not supported"});
}

TEST(MjcfNotes, TellWhatIsLeftOutWithElementAndLine) {
  ExpectNote(WithLeg("<joint name='j' stiffness='3'/>"), {"model.xml, line 9: joint 'j'", "spring of stiffness 3"});
  ExpectNote(WithLeg("<joint name='j' springdamper='1 1'/>"), {"joint 'j'", "'springdamper'"});
  ExpectNote(WithLeg("<joint name='j' damping='1 2'/>"), {"joint 'j'", "only the first number of 'damping'"});
  ExpectNote(WithLeg("<joint name='j' type='ball' range='0 50'/>"), {"joint 'j'", "range of a ball joint"});
  ExpectNote(WithLeg("<joint name='j' range='0 50'/>", "<compiler autolimits='false'/>"), {"joint 'j'", "autolimits"});
  ExpectNote(WithLeg("<joint name='j' rnage='0 50'/>"), {"joint 'j'", "'rnage' is unknown", "nearest is 'range'"});
  ExpectNote(WithLeg("<plugin plugin='p'/>"), {"line 9: <plugin>", "left out"});
  ExpectNote(WithLeg("<body name='b' gravcomp='1'/>"), {"body 'b'", "'gravcomp'"});
  ExpectNote(WithLeg("", "<option gravity='0 0 -1.6' density='1.2'><flag contact='disable'/></option>"),
             {"<option>", "gravity is '0 0 -1.6'"});
  ExpectNote(WithLeg("", "<option density='1.2'/>"), {"<option>", "'density' of the medium"});
  ExpectNote(WithLeg("", "<option><flag contact='disable'/></option>"), {"<flag>", "'contact' is disabled"});
  ExpectNote(WithLeg("", "<contact><exclude body1='leg' body2='base'/></contact>"),
             {"line 2: <exclude>", "'leg' and 'base' may touch"});
  ExpectNote(WithLeg("", "<tendon><fixed name='t'><joint joint='j' coef='1'/></fixed></tendon>"),
             {"fixed 't'", "tendon"});
  ExpectNote(WithLeg("", "<actuators/>"), {"<actuators>", "nearest is 'actuator'"});
}

TEST(MjcfNotes, AreNotMoreThanAreRead) {
  std::string many;
  for (int i = 0; i < 3000; ++i) many += "<joint type='ball' range='0 1' x='1'/>";
  ExpectSays(MessageOfLeg(many), {"over 2000 joints"});
  std::string odd;
  for (int i = 0; i < 3000; ++i) odd += "<plugin/>";
  const ConvertedMjcf converted = WithLeg(odd);
  EXPECT_EQ(converted.notes.size(), 1001U);
  EXPECT_EQ(converted.notes.back(), "further notes are not listed");
}

TEST(MjcfBase, FloatsWhateverHoldsIt) {
  const std::string text = MjcfOf(MjcfBodyOf("leg", "<joint name='j'/>"));
  const ConvertedMjcf welded = Converted(Replaced(text, "<freejoint/>", ""));
  EXPECT_EQ(TreeOf(welded).num_dofs(), 1);
  ExpectNote(welded, {"line 4: body 'base'", "no free joint", "here it is a floating base"});
  const std::string planar = Replaced(text, "<freejoint/>", "<joint name='x' type='slide'/><joint name='y'/>");
  const ConvertedMjcf held = Converted(Replaced(planar, "</worldbody>",
                                                "</worldbody><actuator><motor name='m' "
                                                "joint='x'/></actuator>"));
  EXPECT_EQ(TreeOf(held).num_dofs(), 1);
  ExpectNote(held, {"joint 'x'", "joins the robot's first body to the world"});
  ExpectNote(held, {"motor 'm'", "'x', which is left out"});
}

TEST(MjcfNames, AreMadeForWhatHasNone) {
  const std::string text =
      "<mujoco><worldbody><body><freejoint/><geom size='1'/><body><joint/><joint axis='1 0 0'/><geom size='1'/></body>"
      "<body name='body_2'><joint name='body_2_joint'/><geom size='1'/></body></body></worldbody></mujoco>";
  const RobotModel model = TreeOf(Converted(text));
  std::vector<std::string> frames, joints;
  for (const Frame& frame : model.frames) frames.push_back(frame.name);
  for (const Joint& joint : model.joints) joints.push_back(joint.name);
  EXPECT_EQ(frames, (std::vector<std::string>{"body_1", "body_2_2_before", "body_2_2", "body_2"}));
  EXPECT_EQ(joints, (std::vector<std::string>{"body_2_2_joint", "body_2_2_joint_2", "body_2_joint"}));
}

TEST(MjcfNames, OfAnyTextAreReadBack) {
  const std::string name = "a 'b' &quot;c&quot; &lt;&amp;: {x}, \xC3\xA9";
  const std::string quoted = Replaced(name, "'", "&apos;");
  const std::string text =
      Replaced(MjcfOf(MjcfBodyOf("leg", "<joint name='" + quoted + "' armature='0.1'/>")), "made", quoted);
  const ConvertedMjcf converted = Converted(text);
  const RobotModel tree = TreeOf(converted);
  EXPECT_EQ(tree.joints.at(0).name, "a 'b' \"c\" <&: {x}, \xC3\xA9");
  const RobotYaml yaml = ParseRobotYaml(converted.yaml);
  EXPECT_EQ(yaml.motors.at(0).joint, tree.joints[0].name);
  EXPECT_EQ(yaml.name, tree.joints[0].name);
}

}  // namespace
}  // namespace gaitwright
