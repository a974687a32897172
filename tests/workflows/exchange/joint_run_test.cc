// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>

#include "kinematics/base/result.h"
#include "tests/named_robot.h"
#include "tests/workflows/exchange/mcap_bytes.h"
#include "workflows/exchange/joint_run_internal.h"

namespace gaitwright {
namespace {

std::vector<std::string> NamesOf(const RobotModel& model, const std::vector<int>& dofs) {
  std::vector<std::string> names;
  for (const int dof : dofs) names.push_back(model.dof_names[static_cast<std::size_t>(dof)]);
  return names;
}

TEST(JointRun, StemsLackAxes) {
  EXPECT_EQ(StemOf("left_hip_pitch_joint"), "left_hip");
  EXPECT_EQ(StemOf("LHipYawPitch"), "lhip");
  EXPECT_EQ(StemOf("hip_x"), "hip");
  EXPECT_EQ(StemOf("left_knee_joint"), "left_knee");
  EXPECT_EQ(StemOf("roll"), "") << "an axis alone";
}

TEST(JointRun, SuccessiveHingesOfOneStemAreABall) {
  const auto holds = [](const RobotModel& model, const std::vector<std::string>& names) {
    const auto runs = StemRuns(model);
    return std::any_of(runs.begin(), runs.end(), [&](const auto& run) { return NamesOf(model, run) == names; });
  };
  const RobotModel &h1 = NamedRobot("h1"), &nao = NamedRobot("nao");
  EXPECT_TRUE(holds(h1, {"left_hip_yaw_joint", "left_hip_roll_joint", "left_hip_pitch_joint"}));
  EXPECT_TRUE(holds(h1, {"left_knee_joint"}));
  EXPECT_TRUE(holds(nao, {"LAnklePitch", "LAnkleRoll"}));
  std::size_t count = 0;
  for (const auto& run : StemRuns(nao)) count += run.size();
  EXPECT_EQ(count, nao.dof_names.size());
  for (const auto& run : StemRuns(NamedRobot("a1"))) EXPECT_EQ(run.size(), 1U);
}

TEST(JointRun, HasAxesAndPlaceAtZeroPositions) {
  const RobotModel& model = NamedRobot("h1");
  const JointRun run = RunOf(model, {model.DofIndex("left_hip_yaw_joint"), model.DofIndex("left_hip_roll_joint")});
  EXPECT_LT((run.axes[0] - Vector3::UnitZ()).norm(), 1e-9);
  EXPECT_LT((run.axes[1] - Vector3::UnitX()).norm(), 1e-9);
  EXPECT_GT(run.p.y(), 0.02);
  EXPECT_LT(run.p.z(), 0.0);
}

TEST(JointRun, PartnersAreFoundByNameAndStem) {
  const RobotModel& model = NamedRobot("h1");
  const auto partners = PartnersOf(
      model, {"Left_Hip", "LEFT_KNEE", "left_shoulder_pitch_joint", "head", "right_hip_yaw", "right_hip_pitch_joint"});
  EXPECT_EQ(NamesOf(model, partners[0]),
            (std::vector<std::string>{"left_hip_yaw_joint", "left_hip_roll_joint", "left_hip_pitch_joint"}));
  EXPECT_EQ(NamesOf(model, partners[1]), std::vector<std::string>{"left_knee_joint"});
  EXPECT_EQ(
      NamesOf(model, partners[2]),
      (std::vector<std::string>{"left_shoulder_pitch_joint", "left_shoulder_roll_joint", "left_shoulder_yaw_joint"}))
      << "the joints after it have no other partner";
  EXPECT_TRUE(partners[3].empty());
  EXPECT_EQ(NamesOf(model, partners[4]), (std::vector<std::string>{"right_hip_yaw_joint", "right_hip_roll_joint"}))
      << "up to a joint with its own partner";
  EXPECT_EQ(synthetic::WhatOf<InvalidArgument>([&] {
              PartnersOf(model, {"left_knee", "left_knee_joint"});
            }),
            "joints 'left_knee' and 'left_knee_joint' both move joint 'left_knee_joint' of the robot");
}

}  // namespace
}  // namespace gaitwright
