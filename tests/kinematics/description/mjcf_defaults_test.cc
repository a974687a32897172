// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/description/mjcf_defaults_internal.h"
#include "tests/kinematics/description/mjcf_texts.h"

namespace gaitwright {
namespace {

/// A leg with a joint with these attributes, in a body with a childclass.
std::string LegOf(const std::string& joint, const std::string& childclass = "") {
  const std::string pose = childclass.empty() ? "" : "childclass='" + childclass + "'";
  return MjcfBodyOf("leg", "<joint name='j' " + joint + "/>", pose);
}

const std::string kClasses =
    "<compiler angle='radian'/>\n"
    "<default>\n"
    "<joint axis='0 1 0' damping='1'/>\n"
    "<default class='a'><joint range='-1 2' damping='2'/>\n"
    "<default class='b'><joint range='-3 4' frictionloss='0.5'/></default></default>\n"
    "<default class='c'><joint axis='1 0 0'/></default>\n"
    "</default>\n";

Joint JointOf(const std::string& joint, const std::string& childclass = "", const std::string& classes = kClasses) {
  return JointNamed(TreeOf(Converted(MjcfOf(LegOf(joint, childclass), classes))), "j");
}

TEST(MjcfDefaults, OuterClassesStandBehindInnerOnesAndTheElementBeforeAll) {
  const Joint plain = JointOf("");
  EXPECT_EQ(plain.axis_J, Vector3(0, 1, 0));
  EXPECT_EQ(plain.damping, 1.0);
  EXPECT_EQ(plain.type, JointType::kContinuous);
  const Joint inner = JointOf("class='b'");
  EXPECT_EQ(inner.axis_J, Vector3(0, 1, 0));
  EXPECT_EQ(inner.damping, 2.0);
  EXPECT_EQ(inner.friction, 0.5);
  EXPECT_EQ(inner.lower, -3.0);
  const Joint own = JointOf("class='b' range='-5 6' damping='0'");
  EXPECT_EQ(own.upper, 6.0);
  EXPECT_EQ(own.damping, 0.0);
}

TEST(MjcfDefaults, ChildclassHoldsBelowItAndAnOwnClassStandsBeforeIt) {
  EXPECT_EQ(JointOf("", "a").damping, 2.0);
  const Joint other = JointOf("class='c'", "a");
  EXPECT_EQ(other.axis_J, Vector3(1, 0, 0));
  EXPECT_EQ(other.damping, 1.0);  // nothing of class a
  const std::string nested = MjcfBodyOf("thigh", MjcfBodyOf("shank", "<joint name='j'/>"), "childclass='b'");
  EXPECT_EQ(JointNamed(TreeOf(Converted(MjcfOf(nested, kClasses))), "j").friction, 0.5);
  const std::string frame = "<frame childclass='b'>" + LegOf("") + "</frame>";
  EXPECT_EQ(JointNamed(TreeOf(Converted(MjcfOf(frame, kClasses))), "j").friction, 0.5);
}

TEST(MjcfDefaults, SeveralBlocksAddToTheOutermostClass) {
  const std::string more = kClasses + "<default><joint armature='0.3' damping='7'/></default>";
  EXPECT_EQ(JointOf("", "", more).damping, 7.0);
  EXPECT_EQ(JointOf("class='c'", "", more).damping, 1.0);  // it was copied before the second block
  const std::string named = "<default class='robot'><joint damping='3'/></default>";
  EXPECT_EQ(JointOf("class='robot'", "", named).damping, 3.0);
  EXPECT_EQ(JointOf("class='main'", "", named).damping, 3.0);
}

TEST(MjcfDefaults, NumbersThatAnElementLeavesOutOfASizeStay) {
  MjcfAttributes::Values values = {{"size", "1 2 3"}, {"range", "0 1"}, {"euler", "1 2 3"}};
  MergeMjcfValues(values, {{"size", "4 5"}, {"range", "2 3"}, {"quat", "1 0 0 0"}});
  EXPECT_EQ(values.at("size"), "4 5 3");
  EXPECT_EQ(values.at("range"), "2 3");
  EXPECT_FALSE(values.contains("euler"));  // an orientation replaces another
  EXPECT_EQ(values.at("quat"), "1 0 0 0");
}

TEST(MjcfDefaults, WhatIsWrittenForOneKindOfActuatorHoldsForAll) {
  const std::string sections =
      "<default><position forcerange='-7 7'/></default><actuator><motor joint='j' gear='2'/></actuator>";
  EXPECT_EQ(JointOf("", "", sections).effort_limit, 14.0);
}

TEST(MjcfDefaults, RefusesClassesByNameAndLine) {
  const auto with = [](const std::string& classes, const std::string& joint = "") {
    return MjcfMessage(MjcfOf(LegOf(joint), classes));
  };
  ExpectSays(with(kClasses, "class='d'"), {"model.xml, line 16: joint 'j'", "no class 'd'"});
  ExpectSays(with("<default><default class='knee'/></default>", "class='kneee'"), {"nearest is 'knee'"});
  ExpectSays(MjcfMessage(MjcfOf(LegOf("", "z"), kClasses)), {"body 'leg'", "no class 'z'"});
  ExpectSays(with("<default><default><joint/></default></default>"), {"line 2: <default>", "no 'class'"});
  ExpectSays(with("<default><default class='a'/>\n<default class='a'/></default>"),
             {"line 3: default 'a'", "two classes have this name"});
}

}  // namespace
}  // namespace gaitwright
