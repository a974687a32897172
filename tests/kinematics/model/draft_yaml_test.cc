// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/draft_yaml.h"

#include <gtest/gtest.h>

#include "kinematics/model/load_robot.h"
#include "kinematics/model/robot_yaml.h"

namespace gaitwright {
namespace {

const Failure kNoLegs{FailureKind::kBadInput, "no_legs", "LoadRobot", "robot 'x': 0 legs found", {}};

TEST(DraftRobotYaml, NamesTheFeetThatComeDownLowest) {
  const std::string urdf = LoadNamedRobot("nao").value().urdf_text;
  const std::string draft = DraftRobotYaml(urdf, kNoLegs);
  EXPECT_NE(draft.find("# The robot was refused: robot 'x': 0 legs found"), std::string::npos);
  EXPECT_NE(draft.find("\n  - {link: "), std::string::npos);
  EXPECT_NE(draft.find("\n  # - {link: "), std::string::npos);  // arms and the head
  EXPECT_NE(draft.find("joints LHipYawPitch, LHipRoll"), std::string::npos);
  // It is read as it stands: the two feet, and nothing else.
  const RobotYaml yaml = ParseRobotYaml(draft);
  EXPECT_EQ(yaml.feet.size(), 2U);
  EXPECT_TRUE(LoadRobotFromText(urdf, draft).ok());
}

TEST(DraftRobotYaml, IsEmptyForWhatHasNoLimbs) {
  EXPECT_EQ(DraftRobotYaml("<robot name='x'><link name='a'/></robot>", kNoLegs), "");
  EXPECT_EQ(DraftRobotYaml("no URDF", kNoLegs), "");
}

TEST(DraftRobotYaml, IsForWhatAFileCanTell) {
  EXPECT_TRUE(WantsRobotYaml(kNoLegs));
  Failure other = kNoLegs;
  other.code = "urdf_loop";
  EXPECT_FALSE(WantsRobotYaml(other));
}

}  // namespace
}  // namespace gaitwright
