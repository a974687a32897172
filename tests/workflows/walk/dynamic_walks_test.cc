// SPDX-License-Identifier: BSD-3-Clause
#include "tests/workflows/walk/dynamic_walks.h"

#include <gtest/gtest.h>

#include <vector>

#include "kinematics/model/load_robot.h"
#include "tests/unusual_robots.h"

namespace gaitwright {
namespace {

TEST(DynamicWalks, A1Bounds) { ExpectToFly({"bound", 0.8, 1.0}); }

TEST(DynamicWalks, A1TrotsFastWithItsBodyAtOneHeight) {
  WalkRequest request;
  request.gait = "trot";
  request.command.speed_m_s = 1.5;
  request.command.distance_m = 1.2;
  const RobotModel a1 = *LoadNamedRobot("a1");
  const Result<PlannedWalk> planned = PlanWalk(a1, request);
  ASSERT_TRUE(planned.ok()) << planned.failure().message;
  const std::vector<Vector3>& com = planned->motion.plan.centroidal.p_WC;
  for (const Vector3& p : com) ASSERT_NEAR(p.z(), com.front().z(), 0.12 * a1.leg_length_m());
}

TEST(DynamicWalks, A1LeapsOverFourTenthsOfAMetre) { ExpectToFly(OneLeap("flat", 0.4)); }

TEST(DynamicWalks, A1JumpsOverSixTenthsOfAMetreInOneLeap) {
  WalkRequest request;
  request.gait = "jump";
  request.command.distance_m = 0.6;
  ExpectToFly(request);
  const Result<PlannedWalk> planned = PlanWalk(*LoadNamedRobot("a1"), request);
  ASSERT_TRUE(planned.ok());
  EXPECT_EQ(planned->motion.plan.swings.size(), 4U);
}

TEST(DynamicWalks, A1JumpsOntoABlockOf15Centimetres) {
  ExpectToFly(OneLeap("block:height_m=0.15,start_m=0.31,length_m=2", 0.52));
}

TEST(DynamicWalks, A1JumpsDownFromABlockOf15Centimetres) {
  ExpectToFly(OneLeap("block:height_m=0.15,start_m=-1.5,length_m=1.72", 0.6));
}

/// The feet touch a millisecond after the plan's landing, when the base is lower than the block.
TEST(DynamicWalks, A1JumpsDownFromABlockOf20CentimetresInOneLeap) {
  WalkRequest request;
  request.gait = "jump";
  request.terrain = "block:height_m=0.2,start_m=-1.5,length_m=1.72";
  request.command.distance_m = 0.6;
  ExpectToFly(request);
}

TEST(DynamicWalks, ABipedHopsInPlace) {
  WalkRequest request;
  request.gait = "hop";
  request.command.extent = WalkCommand::Extent::kSteps;
  request.command.steps = 6;
  ExpectToFly(*LoadRobotFromText(unusual::Runner(), ""), request);
}

/// Its waist pitch joint (35 N m) cannot lift both feet as far as usual; the whole body plans a lower path of the feet.
TEST(DynamicWalks, TheG1HopsInPlace) {
  WalkRequest request;
  request.gait = "hop";
  request.command.extent = WalkCommand::Extent::kSteps;
  request.command.steps = 4;
  request.command.step_length_m = 0.0;
  const RobotModel g1 = LoadNamedRobot("g1").value();
  ExpectToFly(g1, request);
  const Result<PlannedWalk> planned = PlanWalk(g1, request);
  ASSERT_TRUE(planned.ok());
  for (const SwingTrajectory& swing : planned->motion.plan.swings) EXPECT_GT(swing.clearance_m, 0.003);
  PlayRequest mujoco;
  mujoco.play.world.engine = "mujoco";
  const Result<PlayedWalk> played = PlayWalk(g1, planned->motion.plan, mujoco);
  ASSERT_TRUE(played.ok());
  EXPECT_TRUE(played->pass()) << played->report.reason;
}

TEST(DynamicWalks, ABipedRuns) {
  WalkRequest request;
  request.gait = "run";
  request.command.speed_m_s = 0.8;
  request.command.distance_m = 0.6;
  ExpectToFly(*LoadRobotFromText(unusual::Runner(), ""), request);
}

}  // namespace
}  // namespace gaitwright
