// SPDX-License-Identifier: BSD-3-Clause
#include "planning/footsteps/route_of.h"

#include <gtest/gtest.h>

#include <cmath>

#include "kinematics/model/load_robot.h"
#include "planning/gait/find_gait.h"
#include "planning/paths/travel_cost.h"
#include "tests/named_robot.h"
#include "tests/planning/paths/walled_grounds.h"

namespace gaitwright {
namespace {

Result<BaseRoute> RouteFor(const WalkCommand& command, const Terrain& terrain) {
  const Gait gait = *FindGait(NamedRobot("a1"), "", CommandedSpeed(NamedRobot("a1"), command), {});
  return RouteOf(NamedRobot("a1"), terrain, command, *MakeCourse(NamedRobot("a1"), gait, command, {1.0}), {});
}

WalkCommand GoalAt(double x, double y, double yaw) {
  WalkCommand command;
  command.extent = WalkCommand::Extent::kGoal;
  command.goal_x_m = x;
  command.goal_y_m = y;
  command.goal_yaw_rad = yaw;
  return command;
}

const Terrain kWall = Walled({Wall("garden wall", {1.5, -1.0}, {1.5, 1.0})});

TEST(RouteOf, FollowsTheCourseWithoutObstacles) {
  const auto route = RouteFor(GoalAt(2.0, 1.0, 0.8), FlatTerrain());
  ASSERT_TRUE(route.ok());
  EXPECT_TRUE(route->statistics.direct);
  const PlanarTwist twist = TwistTo({2.0, 1.0, 0.8});
  const PlanarPose middle = PoseAlong(twist, 0.5), at = route->waypoints[route->waypoints.size() / 2];
  EXPECT_NEAR(std::hypot(at.x_m - middle.x_m, at.y_m - middle.y_m), 0.0, 0.06);
}

TEST(RouteOf, AGoalBehindAWallIsReachedAroundIt) {
  const auto route = RouteFor(GoalAt(3.0, 0.0, 0.0), kWall);
  ASSERT_TRUE(route.ok()) << route.failure().message;
  EXPECT_FALSE(route->statistics.direct);
  EXPECT_GT(route->length_m, 3.5);
  EXPECT_NEAR(route->waypoints.back().x_m, 3.0, 1e-9);
}

TEST(RouteOf, ADirectRouteBesideABlockedCourseIsAnotherRoute) {
  // The arc to a goal with a heading to the right bulges to the left, where the wall is; the straight path is free.
  const PlanarPose goal{3.0, 0.0, -1.57};
  const Terrain beside = Walled({Wall("garden wall", {1.5, 0.6}, {1.5, 2.0})});
  const PlanarPose middle = PoseAlong(TwistTo(goal), 0.5);
  ASSERT_GT(middle.y_m, 0.6);
  const auto route = RouteFor(GoalAt(goal.x_m, goal.y_m, goal.yaw_rad), beside);
  ASSERT_TRUE(route.ok()) << route.failure().message;
  EXPECT_FALSE(route->statistics.direct);
  for (const PlanarPose& pose : route->waypoints) EXPECT_LT(std::abs(pose.y_m), 0.1);
}

TEST(RouteOf, OtherCommandsAreRefusedWithTheNameOfTheObstacle) {
  WalkCommand distance, duration, steps;
  distance.distance_m = 3.0;
  duration.extent = WalkCommand::Extent::kDuration;
  duration.duration_s = 20.0;
  duration.speed_m_s = 0.3;
  steps.extent = WalkCommand::Extent::kSteps;
  steps.steps = 60;
  steps.step_length_m = 0.1;
  for (const WalkCommand& command : {distance, duration, steps}) {
    const auto route = RouteFor(command, kWall);
    ASSERT_FALSE(route.ok());
    EXPECT_EQ(route.failure().kind, FailureKind::kInfeasible);
    EXPECT_EQ(route.failure().code, FailureCode::kWayBlocked);
    EXPECT_NE(route.failure().message.find("'garden wall' blocks the robot"), std::string::npos)
        << route.failure().message;
    EXPECT_TRUE(RouteFor(command, FlatTerrain()).ok());
  }
  distance.distance_m = 0.8;
  EXPECT_TRUE(RouteFor(distance, kWall).ok()) << "it ends before the wall";
}

TEST(RouteOf, LongTurnsAreFollowedCompletely) {
  WalkCommand turn;
  turn.extent = WalkCommand::Extent::kDuration;
  turn.duration_s = 30.0;
  turn.yaw_rate_rad_s = 0.5;
  const auto route = RouteFor(turn, kWall);
  ASSERT_TRUE(route.ok()) << route.failure().message;
  EXPECT_GT(route->waypoints.back().yaw_rad, 14.0);
  EXPECT_NEAR(route->length_m, 0.0, 1e-9);
}

}  // namespace
}  // namespace gaitwright
