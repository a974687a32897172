// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "kinematics/model/body_tree.h"
#include "tests/kinematics/description/mjcf_texts.h"

namespace gaitwright {
namespace {

/// A body of 0.1 kg.
std::string Light(const std::string& name, const std::string& inside, const std::string& pos) {
  return Replaced(MjcfBodyOf(name, inside, "pos='" + pos + "'"), "mass='1'", "mass='0.1'");
}

/// A finger and a rod that is tied to it, both on a palm, and a heavy leg. @param palm  position of the palm.
std::string Gripper(const std::string& palm, const std::string& equality) {
  const std::string finger = Light("finger", "<joint name='finger' axis='0 1 0'/><site name='tip'/>", "0.1 0 0");
  const std::string rod = Light("rod", "<joint name='rod' type='ball'/><frame><site name='end'/></frame>", "0 0.1 0");
  const std::string leg = Replaced(MjcfBodyOf("leg", "<joint name='leg'/>", "pos='0 0 -1'"), "mass='1'", "mass='9'");
  return MjcfOf(Light("palm", "<joint name='wrist'/>" + finger + rod, palm) + leg,
                "<equality>" + equality + "</equality>");
}

constexpr const char* kTie = "<connect name='e' body1='rod' body2='finger' anchor='0 0 0'/>";

TEST(MjcfLoops, InAHandStandStillAsTheFileDrawsThem) {
  for (const std::string tie :
       {kTie, "<connect name='e' site1='end' site2='tip'/>", "<weld name='e' body1='rod' body2='finger'/>"}) {
    const ConvertedMjcf converted = Converted(Gripper("0 0 0.3", tie));
    const RobotModel model = TreeOf(converted);
    EXPECT_EQ(model.dof_names, (std::vector<std::string>{"leg", "wrist"}));
    EXPECT_NEAR(model.total_mass_kg, 1.0 + 0.3 + 9.0, 1e-12);
    ExpectNote(converted, {"'e'", "loop of the joints 'rod', 'finger'", "are locked"});
  }
}

TEST(MjcfLoops, WhatLeadsALockedJointIsLockedToo) {
  const std::string leads = "<joint joint1='finger' joint2='wrist' polycoef='0.2 2'/>";
  const RobotModel model = TreeOf(Converted(Gripper("0 0 0.3", leads + kTie)));
  EXPECT_EQ(model.dof_names, (std::vector<std::string>{"leg"}));
  const Frame& palm = model.frames[static_cast<std::size_t>(model.FrameIndex("palm"))];
  EXPECT_NEAR(Eigen::AngleAxisd(palm.X_BF.linear()).angle(), 0.1, 1e-12);
}

TEST(MjcfLoops, InALegOrAHeavyPartAreRefusedWithTheirJoints) {
  ExpectSays(MjcfMessage(Gripper("0 0 -1", kTie)), {"connect 'e'", "loop of the joints 'rod', 'finger'", "tree"});
  ExpectSays(MjcfMessage(Replaced(Gripper("0 0 0.3", kTie), "mass='9'", "mass='0.1'")), {"loop of the joints"});
  ExpectSays(MjcfMessage(Gripper("0 0 0.3", "<connect name='e' body1='leg' body2='palm' anchor='0 0 0'/>")),
             {"loop of the joints 'leg', 'wrist'"});
}

TEST(MjcfLoops, TiesToTheWorldAreRefused) {
  ExpectSays(MjcfMessage(Gripper("0 0 0.3", "<connect name='e' body1='palm' anchor='0 0 0'/>")),
             {"'e'", "to the world"});
}

}  // namespace
}  // namespace gaitwright
