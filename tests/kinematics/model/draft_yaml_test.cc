// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/draft_yaml.h"

#include <gtest/gtest.h>

#include "kinematics/model/load_robot.h"
#include "kinematics/model/robot_yaml.h"

namespace gaitwright {
namespace {

const Failure kNoLegs{FailureKind::kBadInput, FailureCode::kNoLegs, "LoadRobot", "robot 'x': 0 legs found", {}};

TEST(DraftRobotYaml, NamesTheFeetThatComeDownLowest) {
  const std::string urdf = LoadNamedRobot("nao").value().urdf_text;
  const std::string draft = DraftRobotYaml(urdf, kNoLegs);
  EXPECT_NE(draft.find("# The robot was refused: robot 'x': 0 legs found"), std::string::npos);
  EXPECT_NE(draft.find("\n  - {link: "), std::string::npos);
  EXPECT_NE(draft.find("\n  # - {link: "), std::string::npos);  // arms and the head
  EXPECT_NE(draft.find("joints LHipYawPitch, LHipRoll"), std::string::npos);
  // The draft can be read: it contains the two feet and nothing else.
  const RobotYaml yaml = ParseRobotYaml(draft);
  EXPECT_EQ(yaml.feet.size(), 2U);
  EXPECT_TRUE(LoadRobotFromText(urdf, draft).ok());
}

std::string Link(const std::string& name) {
  return "<link name='" + name +
         "'><inertial><origin xyz='0 0 -0.1'/><mass value='1'/><inertia ixx='0.1' iyy='0.1' izz='0.1' ixy='0' ixz='0' "
         "iyz='0'/></inertial></link>";
}

std::string Hip(const std::string& leg, const std::string& y) {
  return "<joint name='hip_" + leg + "' type='revolute'><origin xyz='0 " + y +
         " 0'/><parent link='body'/><child link='" + leg +
         "'/><axis xyz='0 1 0'/><limit lower='-1' upper='1' effort='10' velocity='10'/></joint>";
}

/// With limbs of one joint, the draft is for a robot that stands, and it says that the robot cannot walk.
TEST(DraftRobotYaml, NamesLimbsOfOneJointToo) {
  const std::string one = "<robot name='x'>" + Link("body") + Link("l") + Hip("l", "0.1");
  for (const std::string& urdf : {one + "</robot>", one + Link("r") + Hip("r", "-0.1") + "</robot>"}) {
    const Result<RobotModel> alone = LoadRobotFromText(urdf, "");
    ASSERT_FALSE(alone.ok());
    EXPECT_NE(alone.failure().message.find("has one joint, such as 'hip_l'"), std::string::npos)
        << alone.failure().message;
    const std::string draft = DraftRobotYaml(urdf, alone.failure());
    EXPECT_NE(draft.find("\n  - {link: 'l'}  # joints hip_l;"), std::string::npos) << draft;
    EXPECT_NE(draft.find("# Each limb has one joint: the robot can stand"), std::string::npos) << draft;
    const Result<RobotModel> model = LoadRobotFromText(urdf, draft);
    ASSERT_TRUE(model.ok()) << model.failure().message;
    EXPECT_EQ(model->feet.size(), model->joints.size());
  }
}

TEST(DraftRobotYaml, WhereNothingMovesTheMessageSaysSo) {
  const Result<RobotModel> model = LoadRobotFromText("<robot name='x'>" + Link("body") + "</robot>", "");
  ASSERT_FALSE(model.ok());
  EXPECT_NE(model.failure().message.find("its description has no moving joints"), std::string::npos)
      << model.failure().message;
  ASSERT_EQ(model.failure().suggestions.size(), 1U);
  EXPECT_NE(model.failure().suggestions[0].text.find("a robot.yaml cannot"), std::string::npos)
      << model.failure().suggestions[0].text;
}

TEST(DraftRobotYaml, IsEmptyForWhatHasNoLimbs) {
  EXPECT_EQ(DraftRobotYaml("<robot name='x'><link name='a'/></robot>", kNoLegs), "");
  EXPECT_EQ(DraftRobotYaml("no URDF", kNoLegs), "");
}

TEST(DraftRobotYaml, IsForWhatAFileCanTell) {
  EXPECT_TRUE(WantsRobotYaml(kNoLegs));
  Failure other = kNoLegs;
  other.code = FailureCode::kUrdfLoop;
  EXPECT_FALSE(WantsRobotYaml(other));
}

}  // namespace
}  // namespace gaitwright
