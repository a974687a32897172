// SPDX-License-Identifier: BSD-3-Clause
#include "planning/footsteps/uneven_footsteps.h"

#include <gtest/gtest.h>

#include <cmath>

#include "grounds.h"
#include "kinematics/model/load_robot.h"
#include "planning/gait/find_gait.h"
#include "planning/terrain/load_terrain.h"

namespace gaitwright {
namespace {

Result<FootstepSkeleton> Plan(const char* robot, const char* gait, const Terrain& terrain, const WalkCommand& command) {
  const RobotModel model = LoadNamedRobot(robot).value();
  const Gait found = FindGait(model, gait, CommandedSpeed(model, command), {}).value();
  return PlanFootsteps(model, terrain, found, command, {});
}

/// Level ground of several patches, so that it is treated as uneven.
Terrain LevelPatches() {
  Terrain terrain = FlatTerrain();
  terrain.patches.push_back(Rectangle("aside", {0.0, 8.0}, {1.0, 9.0}, 0.1));
  return terrain;
}

void ExpectWhole(const FootstepSkeleton& skeleton, int num_feet) {
  EXPECT_NO_THROW(CheckSchedule(skeleton.schedule, num_feet));
  for (int foot = 0; foot < num_feet; ++foot) {
    std::size_t k = 0;
    const auto intervals = IntervalsOf(skeleton.schedule, foot);
    for (const Foothold& foothold : skeleton.footsteps.footholds) {
      if (foothold.foot != foot) continue;
      ASSERT_LT(k, intervals.size());
      EXPECT_EQ(foothold.touchdown_s, intervals[k].start_s);
      EXPECT_EQ(foothold.liftoff_s, intervals[k].end_s);
      EXPECT_GE(foothold.patch, 0);
      ++k;
    }
    EXPECT_EQ(k, intervals.size());
  }
  const auto& path = skeleton.path;
  EXPECT_EQ(path.time_s.front(), 0.0);
  EXPECT_EQ(path.time_s.back(), skeleton.schedule.end_s());
  for (std::size_t i = 1; i < path.pose.size(); ++i) {
    const double step = std::hypot(path.pose[i].x_m - path.pose[i - 1].x_m, path.pose[i].y_m - path.pose[i - 1].y_m);
    EXPECT_LT(step, 0.02);  // 2 m/s
  }
}

TEST(UnevenFootsteps, ReachDistanceGoalDurationAndStepsOnTheGround) {
  WalkCommand distance, goal, duration, steps;
  distance.distance_m = 1.0;
  goal.extent = WalkCommand::Extent::kGoal;
  goal.goal_x_m = 0.6;
  goal.goal_y_m = 0.3;
  goal.goal_yaw_rad = 0.4;
  duration.extent = WalkCommand::Extent::kDuration;
  duration.speed_m_s = 0.2;
  duration.duration_s = 4.0;
  steps.extent = WalkCommand::Extent::kSteps;
  steps.steps = 10;
  steps.step_length_m = 0.03;
  for (const char* robot : {"a1", "nao"}) {
    const bool quadruped = robot[0] == 'a';
    if (!quadruped) duration.speed_m_s = 0.05;
    for (const WalkCommand& command : {distance, goal, duration, steps}) {
      const auto skeleton = Plan(robot, quadruped ? "trot" : "", LevelPatches(), command);
      ASSERT_TRUE(skeleton.ok()) << robot << ": " << skeleton.failure().message;
      ExpectWhole(*skeleton, quadruped ? 4 : 2);
      EXPECT_GT(skeleton->search.expanded, 0);
      const auto level = Plan(robot, quadruped ? "trot" : "", FlatTerrain(), command);
      EXPECT_EQ(level->search.expanded, 0);
      EXPECT_NEAR(skeleton->goal.x_m, level->goal.x_m, 1e-9) << robot;
      EXPECT_NEAR(skeleton->goal.y_m, level->goal.y_m, 1e-9);
      EXPECT_NEAR(skeleton->goal.yaw_rad, level->goal.yaw_rad, 1e-9);
      EXPECT_NEAR(skeleton->path.pose.back().x_m, skeleton->goal.x_m, 0.05);
      EXPECT_NEAR(skeleton->path.pose.back().y_m, skeleton->goal.y_m, 0.05);
      EXPECT_NEAR(skeleton->path.pose.back().yaw_rad, skeleton->goal.yaw_rad, 0.02);
    }
  }
}

TEST(UnevenFootsteps, SidewaysAndOnTheSpotToo) {
  WalkCommand side, turn;
  side.lateral_speed_m_s = -0.03;
  side.distance_m = 0.2;
  turn.yaw_rate_rad_s = 0.2;
  for (const char* robot : {"a1", "nao"}) {
    for (const WalkCommand& command : {side, turn}) {
      const auto skeleton = Plan(robot, robot[0] == 'a' ? "trot" : "", LevelPatches(), command);
      ASSERT_TRUE(skeleton.ok()) << robot << ": " << skeleton.failure().message;
      ExpectWhole(*skeleton, robot[0] == 'a' ? 4 : 2);
      EXPECT_NEAR(skeleton->path.pose.back().yaw_rad, skeleton->goal.yaw_rad, 0.02);
      EXPECT_NEAR(skeleton->path.pose.back().y_m, skeleton->goal.y_m, 0.05);
    }
  }
}

TEST(UnevenFootsteps, StandOnTheGroundUnderThemFromTheStart) {
  WalkCommand command;
  command.distance_m = 1.0;
  const Terrain terrain = Rough(-2.0, 4.0, 0.02, 0.5, 3);
  const auto skeleton = Plan("a1", "trot", terrain, command);
  ASSERT_TRUE(skeleton.ok()) << skeleton.failure().message;
  for (const Foothold& foothold : skeleton->footsteps.footholds) {
    const GroundPoint ground = GroundAt(terrain, foothold.X_WF.translation().head<2>());
    EXPECT_NEAR(foothold.X_WF.translation().z(), ground.height_m, 1e-12);
    EXPECT_LT((foothold.X_WF.linear().col(2) - ground.normal_W).norm(), 1e-9);
    EXPECT_EQ(foothold.patch, ground.patch);
  }
}

TEST(UnevenFootsteps, ClimbStairsInOrderAndComeDown) {
  WalkCommand command;
  command.distance_m = 4.0;
  command.speed_m_s = 0.25;
  const auto skeleton = Plan("a1", "crawl", StairsUpAndDown(0.8, 0.07, 0.25, 3), command);
  ASSERT_TRUE(skeleton.ok()) << skeleton.failure().message;
  ExpectWhole(*skeleton, 4);
  double highest = 0.0;
  for (const Foothold& foothold : skeleton->footsteps.footholds)
    highest = std::max(highest, foothold.X_WF.translation().z());
  EXPECT_NEAR(highest, 0.21, 1e-12);
  for (int foot = 0; foot < 4; ++foot)
    EXPECT_EQ(skeleton->footsteps.footholds[static_cast<std::size_t>(FootholdAt(skeleton->footsteps, foot, 1e9))]
                  .X_WF.translation()
                  .z(),
              0.0);
}

TEST(UnevenFootsteps, FollowAPathAroundACorner) {
  const RobotModel model = LoadNamedRobot("a1").value();
  WalkCommand command;
  const Gait gait = FindGait(model, "trot", CommandedSpeed(model, command), {}).value();
  std::vector<PlanarPose> poses;
  for (int i = 0; i <= 20; ++i) poses.push_back({std::sin(0.08 * i), 1.0 - std::cos(0.08 * i), 0.08 * i});
  const auto skeleton = PlanFootstepsAlong(model, LevelPatches(), gait, command, poses, {});
  ASSERT_TRUE(skeleton.ok()) << skeleton.failure().message;
  ExpectWhole(*skeleton, 4);
  EXPECT_NEAR(skeleton->goal.yaw_rad, 1.6, 1e-12);
  EXPECT_NEAR(skeleton->path.pose.back().x_m, std::sin(1.6), 0.05);
  EXPECT_NEAR(skeleton->path.pose.back().yaw_rad, 1.6, 0.05);
}

TEST(UnevenFootsteps, TooFewFootfallsToMoveForwardAreRefused) {
  WalkCommand command;
  command.extent = WalkCommand::Extent::kSteps;
  command.steps = 1;
  command.step_length_m = 0.03;
  const auto skeleton = Plan("nao", "", LevelPatches(), command);
  ASSERT_FALSE(skeleton.ok());
  EXPECT_EQ(skeleton.failure().code, FailureCode::kCommand);
}

/// Ankles of soles need their whole range on a step down.
TEST(UnevenFootsteps, SolesStepDownUpToTheLimitsOfTheirAnkles) {
  const RobotModel nao = LoadNamedRobot("nao").value();
  const Gait gait = FindGait(nao, "", nao.nominal_speed_m_s, {}).value();
  const Terrain block = LoadTerrain("block:height_m=0.035", ScaleOf(nao)).value();
  WalkCommand command;
  command.distance_m = 1.0;
  const FootstepQuery query = CourseQuery(nao, gait, command, {}).value();
  FootstepOptions options;
  EXPECT_FALSE(SearchFootsteps(nao, block, query, options.foothold, options.search).ok()) << "with a margin";
  const Result<FootstepSkeleton> skeleton = SearchSkeleton(nao, block, query, options);
  ASSERT_TRUE(skeleton.ok()) << skeleton.failure().message;
  ExpectWhole(*skeleton, 2);
}

}  // namespace
}  // namespace gaitwright
