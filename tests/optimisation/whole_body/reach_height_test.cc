// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/whole_body/reach_height.h"

#include <gtest/gtest.h>

#include <string>

#include "kinematics/dynamics/dynamics.h"
#include "kinematics/model/load_robot.h"

namespace gaitwright {
namespace {

/// A robot in its standing posture.
struct Standing {
  explicit Standing(const std::string& robot) : model(LoadNamedRobot(robot == "apart" ? "nao" : robot).value()) {
    if (robot == "apart") {  // ankle axes that do not meet, so that the inverse kinematics has no closed form
      for (const Leg& leg : model.legs)
        model.joints[static_cast<std::size_t>(leg.joints.back())].X_PJ.translation().z() -= 0.01;
    }
    DynamicsScratch scratch(model);
    ForwardKinematics(model, StandingConfiguration(model), scratch);
    X_WB = FramePose(scratch, 0, Pose::Identity());
    for (const Foot& foot : model.feet) X_WF.push_back(FramePose(scratch, foot.body, foot.X_BF));
  }
  RobotModel model;
  Pose X_WB;
  std::vector<Pose> X_WF;
};

class ReachHeightTest : public testing::TestWithParam<const char*> {};

TEST_P(ReachHeightTest, HasRoomUpAndDownWhereTheRobotStands) {
  const Standing robot(GetParam());
  const auto changes = ReachHeight(robot.model).Changes(robot.X_WB, robot.X_WF, 0.01);
  ASSERT_TRUE(changes);
  EXPECT_LT(changes->low, 0.0);
  EXPECT_GT(changes->high, 0.0);
}

TEST_P(ReachHeightTest, EndsWhereInverseKinematicsDoes) {
  const Standing robot(GetParam());
  const auto changes = ReachHeight(robot.model).Changes(robot.X_WB, robot.X_WF, 0.0);
  ASSERT_TRUE(changes);
  const auto reaches = [&](double change_m) {
    Pose X_WB = robot.X_WB;
    X_WB.translation().z() += change_m;
    return LegIk(robot.model, 0).Solve(X_WB.inverse() * robot.X_WF[0]).ok();
  };
  EXPECT_TRUE(reaches(0.98 * changes->high));
  EXPECT_TRUE(reaches(0.98 * changes->low));
  const double leg_m = robot.model.leg_length_m();
  const double most_m = 0.23 * leg_m, beyond_m = 0.01 * leg_m;
  if (std::string(GetParam()) == "apart") {
    EXPECT_EQ(LegIk(robot.model, 0).method(), LegIk::Method::kDamped);
  }
  EXPECT_TRUE(changes->high >= most_m || !reaches(changes->high + beyond_m));
  EXPECT_TRUE(changes->low <= -most_m || !reaches(changes->low - beyond_m));
}

TEST_P(ReachHeightTest, AFootFarBehindAsksForALowerBody) {
  Standing robot(GetParam());
  const double leg_m = robot.model.leg_length_m();
  const ReachHeight height(robot.model);
  double high = 1.0;
  for (int step = 0; step < 30; ++step) {
    const auto changes = height.Changes(robot.X_WB, robot.X_WF, 0.0);
    if (!changes) break;
    EXPECT_LE(changes->high, high + 1e-3 * leg_m);
    high = changes->high;
    robot.X_WF[0].translation().x() -= 0.05 * leg_m;
  }
  EXPECT_LT(high, 0.0);
  robot.X_WF[0].translation().x() -= 2.0 * leg_m;
  EXPECT_FALSE(height.Changes(robot.X_WB, robot.X_WF, 0.0));
}

INSTANTIATE_TEST_SUITE_P(Robots, ReachHeightTest, testing::Values("a1", "nao", "apart"));

}  // namespace
}  // namespace gaitwright
