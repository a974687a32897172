// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "playback/policy/policy_controller_internal.h"

namespace gaitwright {
namespace {

constexpr double kSameTime = 1e-9;  // [s]

}  // namespace

PolicyController::PolicyController(const RobotModel& model, std::shared_ptr<const FittedPolicy> policy, double start_s,
                                   const GainOptions& gains)
    : policy_(std::move(policy)),
      start_s_(start_s),
      standing_(StandingConfiguration(model).tail(model.num_dofs())),
      observer_(policy_->contract, static_cast<int>(policy_->outputs.size())) {
  const Gains derived = DeriveGains(model, gains);
  command_.stiffness = derived.stiffness;
  command_.damping = derived.damping;
  const auto joints = static_cast<Eigen::Index>(policy_->joints.size());
  state_.default_position.resize(joints);
  for (Eigen::Index i = 0; i < joints; ++i) {
    const PolicyJoint& joint = policy_->joints[static_cast<std::size_t>(i)];
    command_.stiffness[joint.dof] = gains.stiffness_scale * joint.stiffness;
    command_.damping[joint.dof] = gains.damping_scale * joint.damping;
    standing_[joint.dof] = state_.default_position[i] = joint.default_position;
  }
  command_.v = command_.tau_ff = VectorX::Zero(standing_.size());
  state_.joint_position = state_.joint_velocity = VectorX::Zero(joints);
  if (policy_->source.network != nullptr) scratch_ = policy_->source.network->MakeScratch();
  PolicyController::Reset();
}

void PolicyController::Reset() {
  decided_ = -1;
  observer_.Reset();
  action_ = Eigen::VectorXf::Zero(static_cast<Eigen::Index>(policy_->outputs.size()));
  state_.last_action = action_;
  if (policy_->source.network != nullptr) scratch_ = policy_->source.network->MakeScratch();
  HoldDefaults();
}

void PolicyController::HoldDefaults() { command_.q = standing_; }

void PolicyController::Observe(const ControlInput& input, double since_start_s) {
  state_.R_WB = BaseRotation(input.q);
  state_.height_m = input.q[2];
  state_.v_WB = input.v.head<3>();
  state_.w_WB = input.v.segment<3>(3);
  state_.command = policy_->commands.At(since_start_s).AsVector();
  for (Eigen::Index i = 0; i < state_.joint_position.size(); ++i) {
    const int dof = policy_->joints[static_cast<std::size_t>(i)].dof;
    state_.joint_position[i] = input.q[7 + dof];
    state_.joint_velocity[i] = input.v[6 + dof];
  }
  state_.time_s = since_start_s;
}

void PolicyController::Decide() {
  const Eigen::VectorXf& observation = observer_.Observe(state_);
  if (policy_->source.function) {
    const Eigen::VectorXf action = policy_->source.function(observation);
    if (action.size() != action_.size())
      throw InvalidArgument(fmt::format("policy '{}' gave {} numbers; {} are needed", policy_->source.name,
                                        action.size(), action_.size()));
    action_ = action;
  } else {
    policy_->source.network->Evaluate(observation, scratch_, action_);
  }
  state_.last_action = action_;
  for (std::size_t i = 0; i < policy_->outputs.size(); ++i) {
    const PolicyOutput& output = policy_->outputs[i];
    const int dof = policy_->joints[static_cast<std::size_t>(output.joint)].dof;
    const double target = output.offset + output.scale * static_cast<double>(action_[static_cast<Eigen::Index>(i)]);
    command_.q[dof] = std::clamp(target, output.lowest, output.highest);
  }
}

JointCommand PolicyController::Update(const ControlInput& input) {
  const double since_start_s = input.time_s - start_s_;
  if (since_start_s <= kSameTime) return command_;
  const long due = std::lround(std::floor((since_start_s + kSameTime) / policy_->contract.step_s));
  if (due <= decided_) return command_;
  decided_ = due;
  Observe(input, static_cast<double>(due) * policy_->contract.step_s);
  Decide();
  return command_;
}

}  // namespace gaitwright
