// SPDX-License-Identifier: BSD-3-Clause
#include <benchmark/benchmark.h>

#include <string>

#include "kinematics/model/load_robot.h"
#include "tests/built_paths.h"
#include "workflows/study/trial.h"

namespace gaitwright {
namespace {

/// Controller, state source and disturbances of trials.
struct Conditions {
  std::string controller, state;
  bool disturbed;
};

/// Trials of 5 m of A1's trot at 0.3 m/s, or of 20 steps of NAO, one after the other on one core. Their differences
/// give the cost of disturbances, estimator, sensors and controller.
void TrialCall(benchmark::State& state, const Conditions& conditions) {
  const bool biped = state.range(0) != 0;
  const RobotModel model = LoadNamedRobot(biped ? "nao" : "a1").value();
  WalkRequest walk;
  if (biped) {
    walk.command.extent = WalkCommand::Extent::kSteps;
    walk.command.steps = 20;
    walk.command.step_length_m = 0.04;
  } else {
    walk.command.speed_m_s = 0.3;
    walk.command.distance_m = 5.0;
  }
  const MotionPlan plan = PlanWalk(model, walk).value().motion.plan;
  PlayRequest request;
  request.controller = conditions.controller;
  request.sensing.state = conditions.state;
  request.sensing.sensors = SensorsOfKind("hobby");
  Disturbances disturbances;
  if (conditions.disturbed) {
    const std::string file = biped ? "nao_room.yaml" : "a1_hobby.yaml";
    disturbances = LoadDisturbances(SourceFolder() + "/examples/disturbances/" + file, SensorFields(request)).value();
  }
  const TrialStudy study{model, plan, request, disturbances};
  double simulated_s = 0.0, survived = 0.0;
  int trials = 0;
  for (auto _ : state) {
    const TrialOutcome outcome = PlayTrial(study, trials, SeedOfTrial(1, trials)).value().outcome;
    simulated_s += outcome.ended_s;
    survived += outcome.survived ? 1.0 : 0.0;
    ++trials;
  }
  state.counters["trials_per_s"] = benchmark::Counter(trials, benchmark::Counter::kIsRate);
  state.counters["times_real_time"] = benchmark::Counter(simulated_s, benchmark::Counter::kIsRate);
  state.counters["survived"] = survived / trials;
}

// NOLINTBEGIN(cert-err58-cpp)
BENCHMARK_CAPTURE(TrialCall, whole, Conditions{"stabilised", "estimated", true})
    ->Arg(0)
    ->Arg(1)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(TrialCall, undisturbed, Conditions{"stabilised", "estimated", false})
    ->Arg(0)
    ->Arg(1)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(TrialCall, without_estimator, Conditions{"stabilised", "measured", false})
    ->Arg(0)
    ->Arg(1)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(TrialCall, without_sensors, Conditions{"stabilised", "true", false})
    ->Arg(0)
    ->Arg(1)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(TrialCall, without_stabiliser, Conditions{"joint-pd", "true", false})
    ->Arg(0)
    ->Arg(1)
    ->Unit(benchmark::kMillisecond);
// NOLINTEND(cert-err58-cpp)

}  // namespace
}  // namespace gaitwright
