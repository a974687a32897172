// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "kinematics/model/load_robot.h"
#include "kinematics/spatial/rotation.h"
#include "planning/footsteps/plan_footsteps.h"
#include "planning/gait/find_gait.h"
#include "planning/paths/base_path.h"

namespace gaitwright {
namespace {

Result<FootstepSkeleton> Plan(const char* robot, const WalkCommand& command, const char* gait = "") {
  const Result<RobotModel> model = LoadNamedRobot(robot);
  const Result<Gait> found = FindGait(*model, gait, CommandedSpeed(*model, command), {});
  return PlanFootsteps(*model, FlatTerrain(), *found, command, {});
}

TEST(BasePath, TwistAndPoseAreInverse) {
  for (const PlanarPose pose : {PlanarPose{1.0, 0.5, 0.3}, PlanarPose{-0.4, 0.0, 0.0}, PlanarPose{0.2, -0.7, -2.5}}) {
    const PlanarPose back = PoseAlong(TwistTo(pose), 1.0);
    EXPECT_NEAR(back.x_m, pose.x_m, 1e-12);
    EXPECT_NEAR(back.y_m, pose.y_m, 1e-12);
    EXPECT_NEAR(back.yaw_rad, pose.yaw_rad, 1e-12);
  }
}

TEST(BasePath, ProgressRisesSmoothlyFromZeroToOne) {
  EXPECT_DOUBLE_EQ(ProgressAt(-1.0, 4.0, 1.0), 0.0);
  EXPECT_DOUBLE_EQ(ProgressAt(9.0, 4.0, 1.0), 1.0);
  for (double t = 0.0; t < 3.99; t += 0.01) EXPECT_LE(ProgressAt(t, 4.0, 1.0), ProgressAt(t + 0.01, 4.0, 1.0));
  EXPECT_NEAR(ProgressAt(2.0, 4.0, 1.0), 0.5, 1e-12);
}

TEST(Footsteps, EndExactlyAtTheDistanceInTheStandingStance) {
  WalkCommand command;
  command.speed_m_s = 0.3;
  command.distance_m = 1.7;
  const auto skeleton = Plan("a1", command);
  ASSERT_TRUE(skeleton.ok()) << skeleton.failure().message;
  EXPECT_NEAR(skeleton->goal.x_m, 1.7, 1e-12);
  for (int foot = 0; foot < 4; ++foot) {
    const auto& footholds = skeleton->footsteps.footholds;
    const Vector3 first =
        footholds[static_cast<std::size_t>(FootholdAt(skeleton->footsteps, foot, 0.0))].X_WF.translation();
    const Vector3 last =
        footholds[static_cast<std::size_t>(FootholdAt(skeleton->footsteps, foot, 1e9))].X_WF.translation();
    EXPECT_LT((last - first - Vector3(1.7, 0.0, 0.0)).norm(), 1e-9);
  }
}

TEST(Footsteps, CountedStepsCloseTheFeet) {
  WalkCommand command;
  command.extent = WalkCommand::Extent::kSteps;
  command.steps = 10;
  command.step_length_m = 0.04;
  const auto skeleton = Plan("nao", command);
  ASSERT_TRUE(skeleton.ok());
  EXPECT_EQ(skeleton->footsteps.footholds.size(), 12U);
  EXPECT_NEAR(skeleton->goal.x_m, 0.36, 1e-12);
}

TEST(Footsteps, SideStepsKeepTheFeetApart) {
  WalkCommand command;
  command.extent = WalkCommand::Extent::kGoal;
  command.goal_y_m = 0.2;
  const auto skeleton = Plan("nao", command);
  ASSERT_TRUE(skeleton.ok());
  const auto& schedule = skeleton->schedule;
  for (const ContactPhase& phase : schedule.phases) {
    if (phase.stance != AllFeet(2)) continue;
    const auto at = [&](int foot) {
      return skeleton->footsteps
          .footholds[static_cast<std::size_t>(FootholdAt(skeleton->footsteps, foot, phase.start_s))]
          .X_WF.translation()
          .y();
    };
    EXPECT_GE(at(0) - at(1), 0.1);
  }
}

TEST(Footsteps, RefusesSenselessAndImpossibleCommands) {
  WalkCommand command;
  command.distance_m = 1.0;
  command.speed_m_s = -0.1;
  EXPECT_EQ(Plan("a1", command).failure().kind, FailureKind::kBadInput);
  command.speed_m_s = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(Plan("a1", command).failure().kind, FailureKind::kBadInput);
  command.speed_m_s = 12.0;
  const auto fast = Plan("a1", command);
  ASSERT_FALSE(fast.ok());
  EXPECT_EQ(fast.failure().kind, FailureKind::kInfeasible);
  EXPECT_NE(fast.failure().message.find("the leg reaches"), std::string::npos);
}

}  // namespace
}  // namespace gaitwright
