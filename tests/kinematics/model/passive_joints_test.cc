// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/passive_joints.h"

#include <gtest/gtest.h>

#include "kinematics/model/load_robot.h"
#include "tests/unusual_robots.h"

namespace gaitwright {
namespace {

std::vector<std::string> PassiveOf(const std::string& urdf) {
  const RobotModel model = LoadRobotFromText(urdf, "").value();
  std::vector<std::string> names;
  for (int dof = 0; dof < model.num_dofs(); ++dof) {
    if (IsPassive(model, dof)) names.push_back(model.dof_names[static_cast<std::size_t>(dof)]);
  }
  return names;
}

TEST(PassiveJoints, HaveAnEffortOfZeroInALegOfMotors) {
  EXPECT_EQ(PassiveOf(unusual::Plain()), std::vector<std::string>{});
  unusual::UrdfText::Motion knee = unusual::Knee();
  knee.effort = 0.0;
  EXPECT_EQ(PassiveOf(unusual::FourLegged(unusual::Abduction(), knee)),
            (std::vector<std::string>{"a3_joint", "b3_joint", "c3_joint", "d3_joint"}));
}

TEST(PassiveJoints, AreNoneWhereNoEffortIsKnown) {
  std::string all = unusual::Plain();
  for (std::size_t at = all.find("effort='"); at != std::string::npos; at = all.find("effort='", at + 1)) {
    const std::size_t begin = at + 8;
    all.replace(begin, all.find('\'', begin) - begin, "0");
  }
  EXPECT_EQ(PassiveOf(all), std::vector<std::string>{});
}

TEST(PassiveJoints, AreNotThoseWhoseEffortIsNotGiven) {
  std::string urdf = unusual::Plain();
  const std::size_t at = urdf.find(" effort='");
  urdf.erase(at, urdf.find('\'', at + 9) + 1 - at);
  EXPECT_EQ(PassiveOf(urdf), std::vector<std::string>{});
}

}  // namespace
}  // namespace gaitwright
