// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/upper_body.h"

#include <gtest/gtest.h>

#include "kinematics/model/body_tree.h"
#include "kinematics/model/load_robot.h"
#include "tests/disguised_urdf.h"

namespace gaitwright {
namespace {

std::vector<std::string> NamesOf(const RobotModel& model, const std::optional<Limb>& limb) {
  std::vector<std::string> names;
  if (!limb) return names;
  for (const int dof : limb->dofs) names.push_back(model.dof_names[static_cast<std::size_t>(dof)]);
  return names;
}

TEST(UpperBody, NaoHasTwoArmsAndAHead) {
  const RobotModel nao = LoadNamedRobot("nao").value();
  const UpperBody upper = FindUpperBody(nao);
  const std::vector<std::string> left = NamesOf(nao, upper.left_arm), right = NamesOf(nao, upper.right_arm);
  ASSERT_GE(left.size(), 4U);
  EXPECT_EQ(left.front(), "LShoulderPitch");
  EXPECT_EQ(right.front(), "RShoulderPitch");
  EXPECT_EQ(left.size(), right.size());
  EXPECT_EQ(NamesOf(nao, upper.head), (std::vector<std::string>{"HeadYaw", "HeadPitch"}));
}

TEST(UpperBody, AQuadrupedHasNeither) {
  for (const char* name : {"a1", "go1", "laikago", "mini_cheetah"}) {
    const UpperBody upper = FindUpperBody(LoadNamedRobot(name).value());
    EXPECT_FALSE(upper.left_arm || upper.right_arm || upper.head) << name;
  }
}

/// Arms above a rotating waist, with or without a head.
TEST(UpperBody, ArmsAreFoundAboveAWaist) {
  for (const char* name : {"h1", "humanoid"}) {
    const RobotModel model = LoadNamedRobot(name).value();
    const UpperBody upper = FindUpperBody(model);
    ASSERT_TRUE(upper.left_arm && upper.right_arm) << name;
    const std::vector<Pose> X_OB = BodyPoses(model, model.standing_joints);
    const auto side = [&](const Limb& arm) { return (X_OB[static_cast<std::size_t>(arm.end_body)] * arm.p_BE).y(); };
    EXPECT_GT(side(*upper.left_arm), 0.05) << name;
    EXPECT_LT(side(*upper.right_arm), -0.05) << name;
    EXPECT_GE(upper.left_arm->dofs.size(), 3U) << name;
  }
}

/// Names, frames and signs of joints do not matter.
TEST(UpperBody, IsTheSameInOtherConventions) {
  const RobotModel nao = LoadNamedRobot("nao").value();
  DisguisedUrdf disguise(nao.urdf_text, 3);
  const RobotModel other = LoadRobotFromText(disguise.text(), "").value();
  const UpperBody upper = FindUpperBody(other), own = FindUpperBody(nao);
  ASSERT_TRUE(upper.left_arm && upper.right_arm && upper.head);
  EXPECT_EQ(upper.left_arm->dofs.size(), own.left_arm->dofs.size());
  EXPECT_EQ(upper.head->dofs.size(), own.head->dofs.size());
}

}  // namespace
}  // namespace gaitwright
