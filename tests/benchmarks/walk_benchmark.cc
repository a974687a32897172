// SPDX-License-Identifier: BSD-3-Clause
#include <benchmark/benchmark.h>

#include <algorithm>

#include "kinematics/model/load_robot.h"
#include "workflows/walk/walk.h"

namespace gaitwright {
namespace {

/// 10 s of A1 trot, or 20 steps of NAO.
struct Walk {
  explicit Walk(const benchmark::State& state) : model(LoadNamedRobot(state.range(0) == 0 ? "a1" : "nao").value()) {
    WalkCommand& command = request.command;
    if (state.range(0) == 0) {
      command.speed_m_s = 0.3;
      command.distance_m = 2.4;
    } else {
      command.extent = WalkCommand::Extent::kSteps;
      command.steps = 20;
      command.step_length_m = 0.04;
    }
  }

  MotionPlan Plan() const {
    const Gait gait = FindGait(model, "", CommandedSpeed(model, request.command), {}).value();
    return PlanMotion(model, FlatTerrain(), gait, request.command, request.motion).value().plan;
  }

  RobotModel model;
  WalkRequest request;
};

void PlanMotionCall(benchmark::State& state) {
  const Walk walk(state);
  double planned_s = 0.0;
  for (auto _ : state) planned_s = walk.Plan().duration_s();
  state.counters["planned_s"] = planned_s;
}

void AuditCall(benchmark::State& state) {
  const Walk walk(state);
  const MotionPlan plan = walk.Plan();
  for (auto _ : state) benchmark::DoNotOptimize(Audit(walk.model, plan, {}));
}

/// With a step of 1 ms and all joints; the counter is simulated time divided by CPU time.
void PlayCall(benchmark::State& state, const char* controller, const char* engine) {
  const Walk walk(state);
  const MotionPlan plan = walk.Plan();
  PlayRequest request;
  request.controller = controller;
  request.play.world.engine = engine;
  double times_real_time = 0.0;
  for (auto _ : state) times_real_time = PlayWalk(walk.model, plan, request).value().realtime_factor;
  state.counters["times_real_time"] = times_real_time;
}

/// As PlayCall, with damping, dry friction and rotor inertia in every joint, and motors with curve and thermal limit.
void PlayLossesCall(benchmark::State& state) {
  Walk walk(state);
  const MotionPlan plan = walk.Plan();
  walk.model.motors.resize(walk.model.dof_names.size());
  for (Joint& joint : walk.model.joints) {
    joint.damping = 0.01;
    joint.friction = 0.02 * std::min(joint.effort_limit, 10.0);
  }
  for (int dof = 0; dof < walk.model.num_dofs(); ++dof) {
    Motor& motor = walk.model.motors[static_cast<std::size_t>(dof)];
    motor.rotor_inertia = 1e-4 * std::min(walk.model.dof_effort_limit(dof), 50.0);
    motor.corner_speed = 0.5 * walk.model.LeaderOf(dof).velocity_limit;
    motor.no_load_speed = 2.0 * motor.corner_speed;
    motor.continuous_effort = 0.5 * walk.model.dof_effort_limit(dof);
  }
  double times_real_time = 0.0;
  for (auto _ : state) times_real_time = PlayWalk(walk.model, plan, PlayRequest{}).value().realtime_factor;
  state.counters["times_real_time"] = times_real_time;
}

BENCHMARK(PlanMotionCall)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);
BENCHMARK(AuditCall)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(PlayCall, joint_pd, "joint-pd", "bullet")->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(PlayCall, stabilised, "stabilised", "bullet")->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(PlayCall, mujoco, "stabilised", "mujoco")->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);
BENCHMARK(PlayLossesCall)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace gaitwright
