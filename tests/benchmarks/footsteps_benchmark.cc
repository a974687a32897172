// SPDX-License-Identifier: BSD-3-Clause
#include <benchmark/benchmark.h>

#include "kinematics/ik/leg_workspace.h"
#include "kinematics/model/load_robot.h"
#include "planning/footsteps/search_footsteps.h"
#include "planning/gait/find_gait.h"
#include "tests/planning/footsteps/grounds.h"

namespace gaitwright {
namespace {

/// About 30 footfalls over stepping stones at the robot's scale: A1 trotting, A1 crawling, NAO.
struct StoneWalk {
  explicit StoneWalk(const benchmark::State& state)
      : quadruped(state.range(0) < 2), model(LoadNamedRobot(quadruped ? "a1" : "nao").value()) {
    const double speed = quadruped ? 0.3 : 0.05, length = state.range(0) == 0 ? 1.2 : quadruped ? 1.4 : 1.1;
    query.gait = FindGait(model, state.range(0) == 0 ? "trot" : quadruped ? "crawl" : "", speed, {}).value();
    query.route = RouteAlong({length, 0.0, 0.0}, 0.0);
    query.stride_m = speed * query.gait.cycle_s;
  }

  Terrain Ground(std::uint64_t seed) const {
    return quadruped ? Stones(0.4, 1.3, 0.12, 0.17, 0.015, 1.2, 0.02, seed)
                     : Stones(0.2, 0.8, 0.18, 0.2, 0.005, 1.0, 0.003, seed);
  }

  bool quadruped;
  RobotModel model;
  FootstepQuery query;
};

/// A complete search, including the computation of the legs' workspaces; each time over other stones.
void FootstepsOverStones(benchmark::State& state) {
  const StoneWalk walk(state);
  std::uint64_t seed = 0;
  double footfalls = 0.0, found = 0.0, all = 0.0, bound = 0.0, expanded = 0.0;
  for (auto _ : state) {
    const auto sequence = SearchFootsteps(walk.model, walk.Ground(seed++ % 20), walk.query, {}, {});
    ++all;
    if (!sequence) continue;
    ++found;
    for (const Footfalls& step : sequence->steps) footfalls += static_cast<double>(step.size());
    bound += sequence->stats.bound;
    expanded += sequence->stats.expanded_to_first;
  }
  state.counters["found"] = found / all;
  state.counters["footfalls"] = footfalls / found;
  state.counters["bound"] = bound / found;
  state.counters["expanded_to_first"] = expanded / found;
}

/// The same search until its first solution.
void FirstFootstepsOverStones(benchmark::State& state) {
  const StoneWalk walk(state);
  FootstepSearchOptions options;
  options.improving_expansions = 0;
  std::uint64_t seed = 0;
  for (auto _ : state)
    benchmark::DoNotOptimize(SearchFootsteps(walk.model, walk.Ground(seed++ % 20), walk.query, {}, options).ok());
}

/// One query of a workspace with a cached answer.
void WorkspaceQuery(benchmark::State& state) {
  const RobotModel model = LoadNamedRobot(state.range(0) == 0 ? "a1" : "nao").value();
  LegWorkspace workspace(model, 0, 0.03);
  const Pose X_BF = workspace.standing();
  for (auto _ : state) benchmark::DoNotOptimize(workspace.Reaches(X_BF));
}

BENCHMARK(FootstepsOverStones)->Arg(0)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond);
BENCHMARK(FirstFootstepsOverStones)->Arg(0)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond);
BENCHMARK(WorkspaceQuery)->Arg(0)->Arg(1)->Unit(benchmark::kNanosecond);

}  // namespace
}  // namespace gaitwright
