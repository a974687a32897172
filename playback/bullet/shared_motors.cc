// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "playback/bullet/shared_motors_internal.h"

namespace gaitwright::bullet {
namespace {

constexpr double kMostImpulse = 1e30;

}  // namespace

SharedMotorRow::SharedMotorRow(RobotBody& robot, const Transmission& transmission, Eigen::Index motor,
                               const SharedMotors& motors)
    : JointSpaceConstraint(robot, robot.members(transmission.dofs.front()).front().joint, 6),
      motors_(motors),
      motor_(motor) {
  for (Eigen::Index i = 0; i < transmission.size(); ++i) {
    const int dof = transmission.dofs[static_cast<std::size_t>(i)];
    if (robot.locked(dof)) continue;
    for (const RobotBody::Member& member : robot.members(dof))
      AddTerm(robot.Row(member.joint), transmission.ratios(motor, i) * member.share);
  }
}

void SharedMotorRow::createConstraintRows(btMultiBodyConstraintArray& rows, btMultiBodyJacobianData& data,
                                          const btContactSolverInfo&) {
  const double rotor = motors_.traits().rotor_inertia[motor_];
  if (!motors_.driven() && rotor <= 0.0) return;
  const Response response = Respond(data);
  if (motors_.driven()) {
    const EffortRange range = motors_.ImpulseRange(motor_);
    AddRow({kSharedDrive, motors_.target_velocity(motor_), motors_.SofteningOf(motor_, motor_), range.lowest,
            range.highest},
           response, rows, data);
  }
  if (rotor > 0.0)
    AddRow({kSharedRotor, motors_.start_speed(motor_), 1.0 / rotor, -kMostImpulse, kMostImpulse}, response, rows, data);
}

SharedMotors::SharedMotors(RobotBody& robot, const Transmission& transmission, const std::vector<MotorRow*>& joints,
                           const Traits& traits)
    : transmission_(transmission), joints_(joints), traits_(traits) {
  const Eigen::Index n = transmission.size();
  for (Eigen::Index m = 0; m < n; ++m) rows_.push_back(std::make_unique<SharedMotorRow>(robot, transmission, m, *this));
  inside_ = wanted_ = target_ = start_ = VectorX::Zero(n);
  softness_ = MatrixX::Zero(n, n);
  limits_.assign(static_cast<std::size_t>(n), EffortRange{0.0, 0.0});
}

VectorX SharedMotors::Speeds() const {
  VectorX rates = VectorX::Zero(transmission_.size());
  for (Eigen::Index i = 0; i < rates.size(); ++i) {
    if (const MotorRow* joint = joints_[static_cast<std::size_t>(i)]) rates[i] = joint->Rate();
  }
  return transmission_.ratios * rates;
}

VectorX SharedMotors::SetTarget(const Command& command, const std::vector<EffortRange>& limits) {
  const Eigen::Index n = transmission_.size();
  limits_ = limits;
  start_ = Speeds();
  VectorX feed_forward = VectorX::Zero(n), asked = feed_forward, wanted = feed_forward;  // of the joints
  bool gains = false;
  for (Eigen::Index i = 0; i < n; ++i) {
    const MotorRow* joint = joints_[static_cast<std::size_t>(i)];
    if (joint == nullptr) continue;
    const double pull = command.stiffness[i] * (command.q[i] - joint->Position());
    feed_forward[i] = command.tau_ff[i];
    asked[i] = pull + command.damping[i] * command.v[i];
    wanted[i] = feed_forward[i] + (pull + command.damping[i] * (command.v[i] - joint->Rate()));
    gains = gains || command.stiffness[i] > 0.0 || command.damping[i] > 0.0;
  }
  driven_ = traits_.has_rows && gains;
  wanted_ = transmission_.inverse.transpose() * wanted;
  const VectorX given = driven_ ? VectorX(transmission_.inverse.transpose() * feed_forward) : wanted_;
  for (Eigen::Index m = 0; m < n; ++m) {
    const EffortRange& range = limits_[static_cast<std::size_t>(m)];
    inside_[m] = std::clamp(given[m], range.lowest, range.highest);
  }
  if (driven_) SetRows(command, asked, given - inside_);
  SetReach(command, asked);
  return JointTorques(inside_);
}

void SharedMotors::SetRows(const Command& command, const VectorX& asked, const VectorX& over_limit) {
  constexpr double kLeast = 1e-6;  // share of the stiffest joint's gain
  const double h = traits_.step_s;
  VectorX drive = traits_.torque_scale * (h * h * command.stiffness + h * command.damping);
  drive = drive.cwiseMax(kLeast * drive.maxCoeff());
  const MatrixX yields = transmission_.ratios * drive.cwiseInverse().asDiagonal();  // R G
  softness_ = yields * transmission_.ratios.transpose();
  target_ = traits_.torque_scale * h * (yields * (asked + transmission_.ratios.transpose() * over_limit));
}

/// Sets the distance that motors may move the joints in a step, for the stops of the joints.
void SharedMotors::SetReach(const Command& command, const VectorX& asked) {
  for (Eigen::Index i = 0; i < transmission_.size(); ++i) {
    MotorRow* joint = joints_[static_cast<std::size_t>(i)];
    if (joint == nullptr) continue;
    double largest = 0.0;
    for (Eigen::Index m = 0; m < transmission_.size(); ++m) {
      const double ratio = std::abs(transmission_.ratios(m, i));
      if (ratio > 0.0) largest += ratio * limits_[static_cast<std::size_t>(m)].largest();
    }
    MotorRow::Target target{};
    if (driven_)
      target.from_transmission = std::min(
          largest, std::abs(asked[i]) + std::abs(command.tau_ff[i]) + command.damping[i] * std::abs(joint->Rate()));
    joint->SetTarget(target);
  }
}

EffortRange SharedMotors::ImpulseRange(Eigen::Index motor) const {
  const EffortRange& range = limits_[static_cast<std::size_t>(motor)];
  const double by_torque = traits_.torque_scale * traits_.step_s;
  return {std::max(-kMostImpulse, by_torque * (range.lowest - inside_[motor])),
          std::min(kMostImpulse, by_torque * (range.highest - inside_[motor]))};
}

VectorX SharedMotors::Torques() const {
  VectorX torques = inside_;
  for (Eigen::Index m = 0; m < torques.size(); ++m) {
    SharedMotorRow& row = *rows_[static_cast<std::size_t>(m)];
    const EffortRange& range = limits_[static_cast<std::size_t>(m)];
    if (driven_)
      torques[m] += row.getAppliedImpulse(SharedMotorRow::kSharedDrive) / traits_.step_s / traits_.torque_scale;
    torques[m] = std::clamp(torques[m], range.lowest, range.highest);
  }
  return torques;
}

VectorX SharedMotors::JointTorques(const VectorX& torques) const {
  VectorX joints = transmission_.ratios.transpose() * torques;
  for (Eigen::Index i = 0; i < joints.size(); ++i) {
    if (joints_[static_cast<std::size_t>(i)] == nullptr) joints[i] = 0.0;
  }
  return joints;
}

SharedMotors::Traits TraitsOf(const Transmission& transmission, const WorldOptions& options) {
  SharedMotors::Traits traits{
      .rotor_inertia = VectorX::Constant(transmission.size(), options.rotor_inertia_kg_m2),
      .torque_scale = options.torque_scale,
      .step_s = options.step_s,
      .has_rows = options.actuation != "torque",
  };
  for (Eigen::Index m = 0; options.joint_losses && m < transmission.size(); ++m)
    traits.rotor_inertia[m] += transmission.motors[static_cast<std::size_t>(m)].motor.rotor_inertia;
  return traits;
}

}  // namespace gaitwright::bullet
