// SPDX-License-Identifier: BSD-3-Clause
#include "planning/paths/plan_base_route.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "kinematics/base/result.h"
#include "kinematics/model/load_robot.h"
#include "planning/paths/pose_check.h"
#include "planning/paths/travel_cost.h"
#include "tests/planning/paths/walled_grounds.h"

namespace gaitwright {
namespace {

const RobotModel& Named(const char* name) {
  static const RobotModel a1 = *LoadNamedRobot("a1"), nao = *LoadNamedRobot("nao");
  return std::string(name) == "a1" ? a1 : nao;
}

/// Scale of lengths relative to the robot for which the grounds were made.
double LengthScaleOf(const RobotModel& model) { return model.leg_length_m() / Named("a1").leg_length_m(); }

/// Checks the invariants of a route: it leads from the start to the goal without jumps and is free at every centimetre.
void ExpectSound(const RobotModel& model, const Terrain& terrain, const PlanarPose& goal, const BaseRoute& route) {
  const auto& poses = route.waypoints;
  ASSERT_GE(poses.size(), 2u);
  EXPECT_EQ(poses.front(), PlanarPose{});
  EXPECT_NEAR(std::hypot(poses.back().x_m - goal.x_m, poses.back().y_m - goal.y_m), 0.0, 1e-12);
  EXPECT_NEAR(std::remainder(poses.back().yaw_rad - goal.yaw_rad, 2.0 * std::numbers::pi), 0.0, 1e-9);
  EXPECT_NEAR(route.length_m, LengthOf(poses), 1e-9);
  PoseCheck check(model, terrain, {});
  for (std::size_t i = 1; i < poses.size(); ++i) {
    EXPECT_LE(std::hypot(poses[i].x_m - poses[i - 1].x_m, poses[i].y_m - poses[i - 1].y_m), 0.05 + 1e-9);
    EXPECT_LE(std::abs(poses[i].yaw_rad - poses[i - 1].yaw_rad), 0.1 + 1e-9);
    for (int k = 1; k <= 5; ++k) {
      const auto why = check.ReasonRefused(Between(poses[i - 1], poses[i], k / 5.0));
      // Between two checked poses the robot's space may overlap an obstacle by half of its margin.
      if (why) ADD_FAILURE() << "waypoint " << i << " of " << poses.size() << ": " << why->text;
    }
  }
}

TEST(PlanBaseRoute, GoesDirectlyWithoutObstacles) {
  for (const char* name : {"a1", "nao"}) {
    const PlanarPose goal{2.0, 0.5, 0.4};
    const auto route = PlanBaseRoute(Named(name), FlatTerrain(), {}, goal, {});
    ASSERT_TRUE(route.ok()) << route.failure().message;
    EXPECT_TRUE(route->statistics.direct);
    EXPECT_EQ(route->statistics.iterations, 0);
    EXPECT_LT(route->length_m, 1.02 * std::hypot(2.0, 0.5));
    ExpectSound(Named(name), FlatTerrain(), goal, *route);
  }
}

TEST(PlanBaseRoute, GoesAroundAWallFacingForward) {
  for (const char* name : {"a1", "nao"}) {
    const double s = LengthScaleOf(Named(name));
    const Terrain terrain = Walled({Wall("wall", {1.5 * s, -1.0 * s}, {1.5 * s, 1.0 * s})});
    const PlanarPose goal{3.0 * s, 0.0, 0.0};
    const auto route = PlanBaseRoute(Named(name), terrain, {}, goal, {});
    ASSERT_TRUE(route.ok()) << route.failure().message;
    ExpectSound(Named(name), terrain, goal, *route);
    double forward = 0.0;
    for (std::size_t i = 1; i < route->waypoints.size(); ++i) {
      const PlanarPose &a = route->waypoints[i - 1], &b = route->waypoints[i];
      const double yaw = 0.5 * (a.yaw_rad + b.yaw_rad);
      forward += std::abs(std::cos(yaw) * (b.x_m - a.x_m) + std::sin(yaw) * (b.y_m - a.y_m));
    }
    EXPECT_GT(forward, 0.95 * route->length_m) << name;
  }
}

TEST(PlanBaseRoute, GoesThroughDoorwaysAndCorridorsHardlyWiderThanItsRoom) {
  for (const char* name : {"a1", "nao"}) {
    const double s = LengthScaleOf(Named(name));
    double width = 0.0;
    for (const Shape& box : BodySpaceOf(Named(name), {}).boxes) width = std::max(width, 1.15 * box.size.y());
    const Terrain doorway = Walled({Wall("right", {1.5 * s, -5.0 * s}, {1.5 * s, 0.6 * s - 0.5 * width}),
                                    Wall("left", {1.5 * s, 0.6 * s + 0.5 * width}, {1.5 * s, 5.0 * s})});
    const Terrain corridor = Walled({Wall("right", {1.0 * s, -0.5 * width - 0.05}, {4.0 * s, -0.5 * width - 0.05}),
                                     Wall("left", {1.0 * s, 0.5 * width + 0.05}, {4.0 * s, 0.5 * width + 0.05}),
                                     Wall("far right", {1.0 * s, -5.0 * s}, {1.0 * s, -0.5 * width}),
                                     Wall("far left", {1.0 * s, 0.5 * width}, {1.0 * s, 5.0 * s})});
    for (const Terrain& terrain : {doorway, corridor}) {
      const PlanarPose goal{terrain.obstacles.size() == 2 ? 3.0 * s : 5.0 * s, 0.0, 0.0};
      const auto route = PlanBaseRoute(Named(name), terrain, {}, goal, {});
      ASSERT_TRUE(route.ok()) << name << ": " << route.failure().message;
      ExpectSound(Named(name), terrain, goal, *route);
      EXPECT_LT(route->length_m, 1.2 * goal.x_m) << name;
    }
  }
}

TEST(PlanBaseRoute, LeadsTwentyMetresThroughAMaze) {
  const Terrain maze = Switchback(7, 1.2, 2.2, 1.0);
  const PlanarPose goal{7.2, 0.0, 0.0};
  const auto route = PlanBaseRoute(Named("a1"), maze, {}, goal, {});
  ASSERT_TRUE(route.ok()) << route.failure().message;
  ExpectSound(Named("a1"), maze, goal, *route);
  EXPECT_GT(route->length_m, 17.0);
  EXPECT_LT(route->length_m, 24.0);
  EXPECT_GT(route->statistics.states, 0);
  EXPECT_GE(route->statistics.first_cost_m, route->statistics.last_cost_m);
  EXPECT_GE(route->statistics.first_smooth_cost_m, route->cost_m * (1.0 - 1e-3));
}

/// Length of the shortest path from (0, 0) to (2 x, 0) around a disc with this radius and centre (x, y).
double AroundDisc(double x, double y, double radius) {
  const double distance = std::hypot(x, y), tangent = std::sqrt(distance * distance - radius * radius);
  const double touching = std::atan2(y, x) + std::asin(radius / distance);  // direction of the tangent
  return 2.0 * tangent + radius * 2.0 * touching;
}

TEST(PlanBaseRoute, ABodySpaceThatMayNotTurnTakesTheShortestRouteAroundTheGrownWall) {
  // If lateral motion costs as little as forward motion and turning is expensive, the robot's space only translates, so
  // the shortest path is known: a stretched string around the wall enlarged by that space.
  BaseRouteOptions options;
  options.lateral = options.backward = 1.0;
  options.turn = 5.0;
  for (const char* name : {"a1", "nao"}) {
    const double s = LengthScaleOf(Named(name));
    const Terrain terrain = Walled({Wall("wall", {1.5 * s, -1.0 * s}, {1.5 * s, 0.8 * s}, 0.1 * s)});
    const auto route = PlanBaseRoute(Named(name), terrain, {}, {3.0 * s, 0.0, 0.0}, options);
    ASSERT_TRUE(route.ok()) << route.failure().message;
    double shortest = 0.0;
    for (const Shape& box : BodySpaceOf(Named(name), {}).boxes) {
      const Vector2 middle = box.X_BS.translation().head<2>(), half = 0.5 * box.size.head<2>();
      const Vector2 near(1.45 * s - middle.x() - half.x(), 0.8 * s + half.y());
      const Vector2 far(1.55 * s - middle.x() + half.x(), 0.8 * s + half.y());
      shortest = std::max(shortest, near.norm() + (far - near).norm() + (Vector2(3.0 * s, 0.0) - far).norm());
    }
    EXPECT_GE(route->length_m, shortest * (1.0 - 0.005)) << name;
    EXPECT_LE(route->length_m, shortest * (1.0 + 0.02)) << name;
  }
}

TEST(PlanBaseRoute, AroundACornerItIsHardlyLongerThanATangentRoute) {
  for (const char* name : {"a1", "nao"}) {
    const double s = LengthScaleOf(Named(name));
    const Terrain terrain = Walled({Wall("wall", {3.0 * s, -4.0 * s}, {3.0 * s, 1.5 * s}, 0.02 * s)});
    const auto route = PlanBaseRoute(Named(name), terrain, {}, {6.0 * s, 0.0, 0.0}, {});
    ASSERT_TRUE(route.ok()) << route.failure().message;
    // No path of a space that contains a disc is shorter than that of the disc.
    double inner = 0.0;
    for (const Shape& box : BodySpaceOf(Named(name), {}).boxes) inner = std::max(inner, 0.5 * box.size.y());
    EXPECT_GE(route->length_m, AroundDisc(3.0 * s, 1.5 * s, 0.9 * inner)) << name;
    EXPECT_LE(route->length_m, 1.06 * AroundDisc(3.0 * s, 1.5 * s, inner)) << name;
  }
}

TEST(PlanBaseRoute, SaysWhatBlocksTheStartOrTheGoal) {
  const Terrain terrain = Walled({Wall("pillar", {2.0, -0.1}, {2.0, 0.1})});
  const auto goal = PlanBaseRoute(Named("a1"), terrain, {}, {2.0, 0.0, 0.0}, {});
  ASSERT_FALSE(goal.ok());
  EXPECT_EQ(goal.failure().kind, FailureKind::kInfeasible);
  EXPECT_EQ(goal.failure().code, FailureCode::kGoalBlocked);
  EXPECT_NE(goal.failure().message.find("'pillar' blocks the robot"), std::string::npos) << goal.failure().message;
  const auto start = PlanBaseRoute(Named("a1"), terrain, {2.1, 0.0, 0.5}, {}, {});
  ASSERT_FALSE(start.ok());
  EXPECT_EQ(start.failure().code, FailureCode::kStartBlocked);
  EXPECT_NE(start.failure().message.find("'pillar' blocks the robot"), std::string::npos) << start.failure().message;
}

TEST(PlanBaseRoute, SaysWhatBlocksEverythingBetween) {
  const Terrain closed =
      Walled({Wall("dam", {1.5, -3.0}, {1.5, 3.0}), Wall("left", {-2.0, 3.0}, {5.0, 3.0}, 1.5),
              Wall("right", {-2.0, -3.0}, {5.0, -3.0}, 1.5), Wall("back", {-2.0, -3.0}, {-2.0, 3.0}, 1.5),
              Wall("front", {5.0, -3.0}, {5.0, 3.0}, 1.5)});
  for (const char* name : {"a1", "nao"}) {
    const auto route = PlanBaseRoute(Named(name), closed, {}, {3.0, 0.0, 0.0}, {});
    ASSERT_FALSE(route.ok());
    EXPECT_EQ(route.failure().kind, FailureKind::kInfeasible);
    EXPECT_EQ(route.failure().code, FailureCode::kWayBlocked);
    EXPECT_NE(route.failure().message.find("'dam' blocks the robot"), std::string::npos) << route.failure().message;
  }
}

TEST(PlanBaseRoute, NamesAGapTooWideAndItsWidth) {
  Terrain terrain;
  terrain.patches = {Slab("near", {-1.0, -1.0}, {1.0, 1.0}), Slab("far", {1.5, -1.0}, {3.0, 1.0})};
  const auto route = PlanBaseRoute(Named("a1"), terrain, {}, {2.3, 0.0, 0.0}, {});
  ASSERT_FALSE(route.ok());
  EXPECT_EQ(route.failure().code, FailureCode::kWayBlocked);
  EXPECT_NE(route.failure().message.find("the gap from (1.00, "), std::string::npos) << route.failure().message;
  EXPECT_NE(route.failure().message.find("on is 0.5"), std::string::npos) << route.failure().message;
}

TEST(PlanBaseRoute, WithoutIterationsItSaysThatTheyWereTooFew) {
  BaseRouteOptions options;
  options.iterations = 1;
  const Terrain terrain = Walled({Wall("wall", {1.5, -1.0}, {1.5, 1.0})});
  const auto route = PlanBaseRoute(Named("a1"), terrain, {}, {3.0, 0.0, 0.0}, options);
  ASSERT_FALSE(route.ok());
  EXPECT_EQ(route.failure().code, FailureCode::kWayNotFound);
}

TEST(PlanBaseRoute, IsAPureFunctionWhateverWasPlannedBefore) {
  const Terrain wall = Walled({Wall("wall", {1.5, -1.0}, {1.5, 1.0})}), maze = Switchback(3, 1.2, 1.5, 1.0);
  const auto around = [&] { return PlanBaseRoute(Named("a1"), wall, {}, {3.0, 0.0, 0.0}, {}); };
  const auto through = [&] { return PlanBaseRoute(Named("a1"), maze, {}, {2.4, 0.0, 0.0}, {}); };
  const auto first_around = around(), first_through = through();
  const auto second_through = through(), second_around = around();
  ASSERT_TRUE(first_around.ok());
  ASSERT_TRUE(first_through.ok()) << first_through.failure().message;
  EXPECT_EQ(first_around->waypoints, second_around->waypoints);
  EXPECT_EQ(first_through->waypoints, second_through->waypoints);
  EXPECT_EQ(first_around->summary, second_around->summary);
  EXPECT_EQ(first_through->summary, second_through->summary);
  BaseRouteOptions other;
  other.seed = 1;
  const auto otherwise = PlanBaseRoute(Named("a1"), wall, {}, {3.0, 0.0, 0.0}, other);
  EXPECT_NE(otherwise->statistics.last_cost_m, first_around->statistics.last_cost_m) << "the seed has no effect";
}

TEST(PlanBaseRoute, MoreIterationsNeverCostMore) {
  const Terrain maze = Switchback(4, 1.2, 1.5, 1.0);
  double before = 1e9;
  for (const int iterations : {400, 800, 1600}) {
    BaseRouteOptions options;
    options.iterations = iterations;
    const auto route = PlanBaseRoute(Named("a1"), maze, {}, {3.6, 0.0, 0.0}, options);
    ASSERT_TRUE(route.ok()) << route.failure().message;
    EXPECT_LE(route->cost_m, before * (1.0 + 1e-12)) << iterations;
    before = route->cost_m;
  }
}

TEST(PlanBaseRoute, IsSilent) {
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  const Terrain terrain = Walled({Wall("wall", {1.5, -1.0}, {1.5, 1.0})});
  EXPECT_TRUE(PlanBaseRoute(Named("a1"), terrain, {}, {3.0, 0.0, 0.0}, {}).ok());
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(PlanBaseRoute, RefusesPosesAndOptionsThatMakeNoSense) {
  EXPECT_THROW((void)PlanBaseRoute(Named("a1"), FlatTerrain(), {}, {std::nan(""), 0.0, 0.0}, {}), InvalidArgument);
  BaseRouteOptions options;
  options.lateral = 0.5;
  EXPECT_THROW((void)PlanBaseRoute(Named("a1"), FlatTerrain(), {}, {1.0, 0.0, 0.0}, options), InvalidArgument);
}

}  // namespace
}  // namespace gaitwright
