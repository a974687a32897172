// SPDX-License-Identifier: BSD-3-Clause
#include "planning/paths/coarse_route.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/named_robot.h"
#include "tests/planning/paths/walled_grounds.h"

namespace gaitwright {
namespace {

CoarseProblem CoarseTo(const PlanarPose& goal, double half_width_m = 3.0) {
  CoarseProblem problem;
  problem.goal = goal;
  problem.extent = PlaneExtent(Vector2(std::min(0.0, goal.x_m) - 1.0, -half_width_m),
                               Vector2(std::max(0.0, goal.x_m) + 1.0, half_width_m));
  return problem;
}

CoarseRoute CoarseRouteOn(const Terrain& terrain, const CoarseProblem& problem) {
  PoseCheck check(NamedRobot("a1"), terrain, {});
  return FindCoarseRoute(check, problem);
}

double LeastAbove(const std::vector<PlanarPose>& poses, double x_m) {
  double y = 1e9;
  for (const PlanarPose& pose : poses) {
    if (std::abs(pose.x_m - x_m) < 0.1) y = std::min(y, std::abs(pose.y_m));
  }
  return y;
}

TEST(CoarseRoute, InTheOpenLeadsStraightToTheGoal) {
  const Terrain flat = FlatTerrain();
  for (const double yaw_rad : {0.0, 0.5, -1.2}) {
    const PlanarPose goal{2.0, 0.0, yaw_rad};
    const CoarseRoute route = CoarseRouteOn(flat, CoarseTo(goal));
    EXPECT_TRUE(route.complete);
    EXPECT_FALSE(route.hindrance);
    ASSERT_GT(route.poses.size(), 3U);
    EXPECT_EQ(route.poses.back(), goal);
    EXPECT_NEAR(LengthOf(route.poses), 2.0, 0.15);
  }
}

TEST(CoarseRoute, GoesFromCellToCellFacingEighthsOfATurn) {
  const Terrain flat = FlatTerrain();
  const CoarseRoute route = CoarseRouteOn(flat, CoarseTo({1.5, 1.0, 0.0}));
  ASSERT_TRUE(route.complete);
  for (std::size_t i = 0; i + 1 < route.poses.size(); ++i) {
    const double eighths = route.poses[i].yaw_rad / (0.25 * std::numbers::pi);
    EXPECT_NEAR(eighths, std::round(eighths), 1e-9);
  }
  for (std::size_t i = 1; i + 1 < route.poses.size(); ++i) {
    const double moved =
        std::hypot(route.poses[i].x_m - route.poses[i - 1].x_m, route.poses[i].y_m - route.poses[i - 1].y_m);
    const double turned = std::abs(route.poses[i].yaw_rad - route.poses[i - 1].yaw_rad);
    EXPECT_TRUE(moved < 1e-9 || turned < 1e-9) << "it either moves or turns";
    EXPECT_LT(turned, 0.25 * std::numbers::pi + 1e-9) << "by one heading, without jumps";
  }
}

TEST(CoarseRoute, GoesAroundAWallOnTheShorterSide) {
  for (const double side : {1.0, -1.0}) {
    const Terrain terrain = Walled({Wall("wall", {1.0, -side * 2.5}, {1.0, side * 0.6})});
    const CoarseRoute route = CoarseRouteOn(terrain, CoarseTo({2.0, 0.0, 0.0}, 4.0));
    ASSERT_TRUE(route.complete);
    double y = 0.0;
    for (const PlanarPose& pose : route.poses) y = std::abs(pose.y_m) > std::abs(y) ? pose.y_m : y;
    EXPECT_GT(side * y, 0.6);
    EXPECT_GT(LeastAbove(route.poses, 1.0), 0.6) << "past its end, not through it";
    PoseCheck check(NamedRobot("a1"), terrain, {});
    for (std::size_t i = 0; i + 1 < route.poses.size(); ++i) EXPECT_TRUE(check.IsFree(route.poses[i])) << i;
  }
}

TEST(CoarseRoute, AMirroredProblemCostsAsMuch) {
  const TravelWeights weights;
  double cost[2];
  for (const int i : {0, 1}) {
    const double side = i == 0 ? 1.0 : -1.0;
    const Terrain terrain = Walled({Wall("wall", {1.0, -side * 1.0}, {1.0, side * 0.5})});
    cost[i] = TravelCost(CoarseRouteOn(terrain, CoarseTo({2.0, side * 0.3, 0.0})).poses, weights);
  }
  EXPECT_NEAR(cost[0], cost[1], 0.02 * cost[0]);
}

TEST(CoarseRoute, WithoutARouteTheObstacleIsNamed) {
  const Terrain terrain = Walled({Wall("barrier", {1.0, -3.5}, {1.0, 3.5})});
  const CoarseRoute route = CoarseRouteOn(terrain, CoarseTo({2.0, 0.0, 0.0}));
  EXPECT_FALSE(route.complete);
  ASSERT_TRUE(route.hindrance);
  EXPECT_EQ(route.hindrance->what, "barrier");
  EXPECT_NEAR(route.hindrance->at.x_m, 1.0, 0.6);
  EXPECT_EQ(route.poses.back().x_m, 2.0) << "it goes through";
}

TEST(CoarseRoute, OfTwoWallsThatBlockTheRouteTheThinnerPlaceIsPassed) {
  // A box around the goal that is thick in front and thin behind.
  const Terrain terrain =
      Walled({Wall("thick", {1.5, -1.5}, {1.5, 1.5}, 1.0), Wall("left", {1.0, 1.5}, {4.0, 1.5}, 1.0),
              Wall("right", {1.0, -1.5}, {4.0, -1.5}, 1.0), Wall("thin", {4.0, -1.5}, {4.0, 1.5}, 0.05)});
  CoarseProblem problem = CoarseTo({3.0, 0.0, 0.0});
  problem.extent = PlaneExtent(Vector2(-1.0, -4.0), Vector2(6.0, 4.0));
  const CoarseRoute route = CoarseRouteOn(terrain, problem);
  EXPECT_FALSE(route.complete);
  ASSERT_TRUE(route.hindrance);
  EXPECT_EQ(route.hindrance->what, "thin");
}

TEST(CoarseRoute, StaysWithinItsExtent) {
  const Terrain terrain = Walled({Wall("wall", {1.0, -0.8}, {1.0, 2.0})});
  CoarseProblem problem = CoarseTo({2.0, 0.0, 0.0});
  problem.extent = PlaneExtent(Vector2(-0.5, -0.5), Vector2(2.5, 4.0));
  const CoarseRoute route = CoarseRouteOn(terrain, problem);
  EXPECT_TRUE(route.complete) << "around the far end, as the near one is outside";
  for (const PlanarPose& pose : route.poses) EXPECT_TRUE(problem.extent.contains(Vector2(pose.x_m, pose.y_m)));
}

}  // namespace
}  // namespace gaitwright
