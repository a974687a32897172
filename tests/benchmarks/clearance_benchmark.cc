// SPDX-License-Identifier: BSD-3-Clause
// Speed of clearance checks of feet and bodies against a ground of steps and walls.
#include <benchmark/benchmark.h>

#include "kinematics/dynamics/dynamics.h"
#include "kinematics/model/load_robot.h"
#include "optimisation/swing/plan_swings.h"
#include "planning/audit/ground_watch.h"
#include "planning/plan/sample_plan.h"
#include "planning/plan/terrain_shapes.h"

namespace gaitwright {
namespace {

constexpr double kRise = 0.07, kTread = 0.25;

/// Six treads up from level ground, between two walls.
Terrain Stairs() {
  Terrain terrain = FlatTerrain();
  for (int i = 0; i < 6; ++i) {
    TerrainPatch tread;
    tread.X_WT.translation() = Vector3(0.1 + kTread * i, 0.0, kRise * (i + 1));
    tread.outline_T = {{0.0, -0.5}, {kTread, -0.5}, {kTread, 0.5}, {0.0, 0.5}};
    terrain.patches.push_back(tread);
  }
  for (const double y : {-0.6, 0.6}) {
    Obstacle wall;
    wall.size_m = Vector3(4.0, 0.1, 1.0);
    wall.X_WO.translation() = Vector3(0.0, y, 0.5);
    terrain.obstacles.push_back(wall);
  }
  return terrain;
}

/// One step of foot 0 from the ground onto the first tread.
FootstepPlan StepUp() {
  Foothold from, to;
  from.liftoff_s = 0.0;
  from.X_WF.translation() = Vector3(0.03, 0.0, 0.0);
  to.touchdown_s = 0.4;
  to.liftoff_s = 1.0;
  to.patch = 1;
  to.X_WF.translation() = Vector3(0.22, 0.0, kRise);
  return {{from, to}};
}

/// Distance of a foot to all obstacles, at 100 places along a swing in turn.
void FootAlongSwing(benchmark::State& state) {
  const RobotModel model = LoadNamedRobot("a1").value();
  const GroundWatch watch(model, Stairs());
  const SwingTrajectory swing = PlanSwings(model, Stairs(), StepUp(), {})->front();
  std::vector<Pose> path;
  for (int k = 0; k < 100; ++k) {
    path.push_back(Evaluate(CurveOf(swing), 0.004 * k).X_WF);
    path.back().translation() += model.feet[0].radius * path.back().linear().col(2);
  }
  std::size_t k = 0;
  for (auto _ : state) benchmark::DoNotOptimize(watch.NearestToFoot(0, path[k++ % path.size()], 0.25));
  state.SetItemsProcessed(state.iterations());
}

/// All shapes of the robot against all obstacles; the robot moves 0.5 mm between checks (0.5 m/s at 1 kHz).
void RobotOverStairs(benchmark::State& state) {
  const RobotModel model = LoadNamedRobot("a1").value();
  GroundWatch watch(model, Stairs());
  DynamicsScratch scratch(model);
  GroundLimits limits;
  limits.foot_m.assign(model.feet.size(), -1e-4);
  VectorX q = StandingConfiguration(model);
  constexpr double kStep = 5e-4, kDistance = 1.0;
  double x = 0.0;
  for (auto _ : state) {
    x = x < kDistance ? x + kStep : 0.0;
    q[0] = x;
    q[2] = model.standing_base_height_m + 0.02 + x * kRise / kTread;
    ForwardKinematics(model, q, scratch);
    benchmark::DoNotOptimize(watch.Look(scratch, limits).size());
  }
  state.SetItemsProcessed(state.iterations());
}

/// One swing onto a tread, including checks and detour.
void PlanSwingUp(benchmark::State& state) {
  const RobotModel model = LoadNamedRobot("a1").value();
  const Terrain terrain = Stairs();
  for (auto _ : state) benchmark::DoNotOptimize(PlanSwings(model, terrain, StepUp(), {}));
}

BENCHMARK(FootAlongSwing);
BENCHMARK(RobotOverStairs);
BENCHMARK(PlanSwingUp)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace gaitwright
