// SPDX-License-Identifier: BSD-3-Clause
#include "examples/pd_tuning.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>

#include "kinematics/dynamics/dynamics.h"
#include "playback/play/make_world.h"

namespace gaitwright::examples {
namespace {

/// The robot with a base so heavy that it acts as fixed to the world.
RobotModel Bolted(RobotModel model) {
  Body& base = model.bodies[0];
  base.I_C *= 1e6;
  model.total_mass_kg += 1e6 * base.mass;
  base.mass += 1e6 * base.mass;
  return model;
}

}  // namespace

double SecondOrderStep(double frequency_rad_s, double damping_ratio, double time_s) {
  const double decay = frequency_rad_s * damping_ratio;
  if (damping_ratio == 1.0) return 1.0 - (1.0 + decay * time_s) * std::exp(-decay * time_s);
  const auto root = frequency_rad_s * std::sqrt(std::complex<double>(damping_ratio * damping_ratio - 1.0));
  const auto a = -decay + root, b = -decay - root;
  return 1.0 - ((a * std::exp(b * time_s) - b * std::exp(a * time_s)) / (a - b)).real();
}

JointStep StepJoint(const RobotModel& model, const std::string& joint, double stiffness, double damping,
                    double step_rad) {
  if (!(stiffness > 0.0 && damping >= 0.0 && step_rad != 0.0))
    throw InvalidArgument(
        fmt::format("step {} rad, kp {}, kd {}: the step must not be 0, kp must be more than 0, kd 0 or more", step_rad,
                    stiffness, damping));
  const int dof = model.DofIndex(joint), n = model.num_dofs();
  VectorX q = StandingConfiguration(model);
  q[2] += 20.0;  // [m]; it falls 5 m in 1 s
  DynamicsScratch scratch(model);
  MatrixX M = MatrixX::Zero(model.nv(), model.nv());
  MassMatrix(model, q, scratch, M);
  WorldOptions options;
  options.step_s = 1e-4;
  options.joint_losses = options.motor_curve = options.thermal_limit = false;
  for (int other = 0; other < n; ++other)
    if (other != dof) options.locked_dofs.push_back(other);
  const RobotModel bolted = Bolted(model);
  const std::unique_ptr<World> made = MakeWorld(bolted, FlatTerrain(), q, options);
  World& world = *made;
  world.SetState(q, VectorX::Zero(model.nv()));
  const VectorX zero = VectorX::Zero(n), one = VectorX::Unit(n, dof);
  const JointCommand command{q.tail(n) + step_rad * one, zero, zero, stiffness * one, damping * one};

  JointStep step{.stiffness = stiffness, .damping = damping, .step_s = options.step_s};
  const double I = step.inertia_kg_m2 = M(6 + dof, 6 + dof);
  step.frequency_rad_s = std::sqrt(stiffness / I);
  step.damping_ratio = damping / (2.0 * std::sqrt(stiffness * I));
  for (int k = 1; k <= 10000; ++k) {  // 1 s
    world.Step(command);
    step.simulated.push_back((world.q()[7 + dof] - q[7 + dof]) / step_rad);
    step.formula.push_back(SecondOrderStep(step.frequency_rad_s, step.damping_ratio, k * step.step_s));
    step.torque_use = std::max(step.torque_use, world.effort_use()[dof]);
  }
  return step;
}

StepShape ShapeOf(const std::vector<double>& response, double step_s) {
  const auto when = [&](const auto& reached) {
    return step_s * static_cast<double>(std::find_if(response.begin(), response.end(), reached) - response.begin());
  };
  const auto out = std::find_if(response.rbegin(), response.rend(), [](double x) { return std::abs(x - 1.0) > 0.02; });
  return {when([](double x) { return x >= 0.9; }) - when([](double x) { return x >= 0.1; }),
          std::max(0.0, *std::max_element(response.begin(), response.end()) - 1.0),
          step_s * static_cast<double>(response.rend() - out)};
}

}  // namespace gaitwright::examples
