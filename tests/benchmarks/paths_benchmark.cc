// SPDX-License-Identifier: BSD-3-Clause
#include <benchmark/benchmark.h>

#include "kinematics/model/load_robot.h"
#include "planning/paths/plan_base_route.h"
#include "planning/paths/pose_check.h"
#include "tests/planning/paths/walled_grounds.h"

namespace gaitwright {
namespace {

const char* const kPathRobots[] = {"a1", "nao"};

/// A route, with its length and its cost: of RRT*'s first solution, of its last solution, and of the result.
void PlanRoute(benchmark::State& state, const Terrain& terrain, const PlanarPose& goal) {
  const RobotModel model = LoadNamedRobot(kPathRobots[state.range(0)]).value();
  BaseRouteOptions options;
  options.iterations = static_cast<int>(state.range(1));
  for (auto _ : state) {
    const auto route = PlanBaseRoute(model, terrain, {}, goal, options);
    if (!route) return state.SkipWithError(route.failure().message.c_str());
    state.counters["length_m"] = route->length_m;
    state.counters["first_cost_m"] = route->statistics.first_cost_m;
    state.counters["first_smooth_cost_m"] = route->statistics.first_smooth_cost_m;
    state.counters["last_cost_m"] = route->statistics.last_cost_m;
    state.counters["cost_m"] = route->cost_m;
    state.counters["poses"] = static_cast<double>(route->statistics.poses_checked);
  }
}

void RouteThroughMaze(benchmark::State& state) { PlanRoute(state, Switchback(7, 1.2, 2.2, 1.0), {7.2, 0.0, 0.0}); }

void RouteAroundWall(benchmark::State& state) {
  PlanRoute(state, Walled({Wall("wall", {1.5, -1.0}, {1.5, 1.0})}), {3.0, 0.0, 0.0});
}

void PoseCheckCall(benchmark::State& state) {
  const RobotModel model = LoadNamedRobot(kPathRobots[state.range(0)]).value();
  const Terrain maze = Switchback(7, 1.2, 2.2, 1.0);
  PoseCheck check(model, maze, {});
  double x = 0.0;
  for (auto _ : state) {
    x = x > 6.0 ? 0.0 : x + 0.01;
    benchmark::DoNotOptimize(check.IsFree({x, 0.3 * x, x}));
  }
}

BENCHMARK(RouteThroughMaze)->ArgsProduct({{0, 1}, {300, 1000, 5000}})->Unit(benchmark::kMillisecond);
BENCHMARK(RouteAroundWall)->ArgsProduct({{0, 1}, {300, 1000, 5000}})->Unit(benchmark::kMillisecond);
BENCHMARK(PoseCheckCall)->Arg(0)->Arg(1);

}  // namespace
}  // namespace gaitwright
