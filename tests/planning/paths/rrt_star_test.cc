// SPDX-License-Identifier: BSD-3-Clause
#include "planning/paths/rrt_star.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/named_robot.h"
#include "tests/planning/paths/walled_grounds.h"

namespace gaitwright {
namespace {

/// Record of the paths that a search reports.
struct RrtOutcome {
  std::vector<double> costs;
  std::vector<std::vector<PlanarPose>> routes;
  RrtStarReport report;
};

RrtOutcome RunRrt(const Terrain& terrain, const RrtStarProblem& problem, SampleFocus focus = {}) {
  PoseCheck check(NamedRobot("a1"), terrain, {});
  RrtOutcome outcome;
  outcome.report = SearchRrtStar(check, problem, focus, [&](const std::vector<PlanarPose>& route, double cost) {
    outcome.routes.push_back(route);
    outcome.costs.push_back(cost);
  });
  return outcome;
}

RrtStarProblem AcrossTheWall(int iterations) {
  RrtStarProblem problem;
  problem.goal = {2.0, 0.0, 0.0};
  problem.extent = PlaneExtent(Vector2(-1.0, -2.0), Vector2(3.0, 2.0));
  problem.iterations = iterations;
  problem.seed = 3;
  return problem;
}

Terrain RrtWall() { return Walled({Wall("wall", {1.0, -3.0}, {1.0, 0.4})}); }

TEST(SearchRrtStar, FindsEverCheaperFreeRoutesFromStartToGoal) {
  const Terrain terrain = RrtWall();
  const RrtStarProblem problem = AcrossTheWall(600);
  const RrtOutcome outcome = RunRrt(terrain, problem);
  ASSERT_FALSE(outcome.routes.empty());
  PoseCheck check(NamedRobot("a1"), terrain, {});
  for (std::size_t i = 0; i < outcome.routes.size(); ++i) {
    const std::vector<PlanarPose>& route = outcome.routes[i];
    EXPECT_EQ(route.front(), problem.start);
    EXPECT_EQ(route.back().x_m, problem.goal.x_m);
    EXPECT_TRUE(check.IsFreeAlong(route));
    EXPECT_NEAR(TravelCost(route, problem.weights), outcome.costs[i], 0.02 * outcome.costs[i]);
    if (i > 0) {
      EXPECT_LT(outcome.costs[i], outcome.costs[i - 1]);
    }
    for (std::size_t k = 1; k < route.size(); ++k)
      EXPECT_LE(std::abs(route[k].yaw_rad - route[k - 1].yaw_rad), M_PI + 1e-9) << "yaws do not jump";
  }
  EXPECT_GT(outcome.costs.back(), 2.0) << "no way is shorter than the straight line";
}

TEST(SearchRrtStar, IsAPureFunctionOfItsSeed) {
  const Terrain terrain = RrtWall();
  const RrtOutcome once = RunRrt(terrain, AcrossTheWall(300)), again = RunRrt(terrain, AcrossTheWall(300));
  EXPECT_EQ(once.costs, again.costs);
  EXPECT_EQ(once.routes, again.routes);
  EXPECT_EQ(once.report.states, again.report.states);
  RrtStarProblem other = AcrossTheWall(300);
  other.seed = 4;
  EXPECT_NE(RunRrt(terrain, other).routes, once.routes);
}

TEST(SearchRrtStar, MoreIterationsBeginWithTheSameRoutes) {
  const Terrain terrain = RrtWall();
  const RrtOutcome few = RunRrt(terrain, AcrossTheWall(250)), more = RunRrt(terrain, AcrossTheWall(500));
  ASSERT_GE(more.costs.size(), few.costs.size());
  for (std::size_t i = 0; i < few.costs.size(); ++i) EXPECT_EQ(more.costs[i], few.costs[i]);
  EXPECT_GT(more.report.states, few.report.states);
}

TEST(SearchRrtStar, TakesNoMoreIterationsThanItIsGiven) {
  const Terrain terrain = RrtWall();
  for (const int iterations : {0, 1, 50}) {
    const RrtOutcome outcome = RunRrt(terrain, AcrossTheWall(iterations));
    EXPECT_LE(outcome.report.iterations, iterations);
  }
  EXPECT_TRUE(RunRrt(terrain, AcrossTheWall(0)).routes.empty());
}

TEST(SearchRrtStar, AGuideLeadsToARouteAtOnce) {
  const Terrain terrain = RrtWall();
  RrtStarProblem problem = AcrossTheWall(40);
  problem.guide = {{0.3, 0.6, 0.0}, {0.6, 1.2, 0.0}, {1.0, 1.3, 0.0}, {1.5, 1.2, 0.0}, {1.8, 0.6, 0.0}, problem.goal};
  EXPECT_FALSE(RunRrt(terrain, problem).routes.empty());
}

TEST(SearchRrtStar, WhereNothingLeadsThroughItFindsNothing) {
  const Terrain terrain = Walled({Wall("barrier", {1.0, -3.0}, {1.0, 3.0})});
  const RrtOutcome outcome = RunRrt(terrain, AcrossTheWall(200));
  EXPECT_TRUE(outcome.routes.empty());
  EXPECT_GT(outcome.report.states, 10) << "though it looked";
}

}  // namespace
}  // namespace gaitwright
