// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <optional>

#include "playback/bullet/contact_rows_internal.h"
#include "playback/bullet/joint_rows_internal.h"

namespace gaitwright::bullet {
namespace {

constexpr double kUnlimited = 1e30;      // impulse
constexpr double kGearCorrection = 0.5;  // share of a gear's error that one step corrects

}  // namespace

JointSpaceConstraint::JointSpaceConstraint(RobotBody& robot, int link, int rows)
    : btMultiBodyConstraint(&robot.multibody(), nullptr, link, -1, rows, false, MULTIBODY_CONSTRAINT_1DOF_JOINT_MOTOR),
      inertia_(robot.inertia()),
      jacobian_(VectorX::Zero(inertia_.size())) {
  m_data.resize(rows);
}

int JointSpaceConstraint::getIslandIdA() const { return m_bodyA->getBaseCollider()->getIslandTag(); }

void JointSpaceConstraint::AddTerm(int dof_row, double share) {
  if (share == 0.0) return;
  terms_.push_back({6 + dof_row, share});
  jacobian_[6 + dof_row] = share;
}

JointSpaceConstraint::Response JointSpaceConstraint::Respond(btMultiBodyJacobianData& data) {
  Response result{AddJacobian(inertia_.size(), data), 0.0};
  double* J = &data.m_jacobians[result.at];
  for (const Term& term : terms_) {
    J[term.coordinate] = term.share;
    result.velocity += term.share * m_bodyA->getVelocityVector()[term.coordinate];
  }
  return result;
}

double JointSpaceConstraint::InverseInertia() const {
  const Term& first = terms_.front();
  if (terms_.size() == 1) return first.share * first.share * inertia_.InverseAt(first.coordinate);
  return inertia_.InverseAlong(jacobian_.data());
}

void JointSpaceConstraint::AddRow(const Row& wanted, const Response& response, btMultiBodyConstraintArray& rows,
                                  btMultiBodyJacobianData& data) {
  btMultiBodySolverConstraint& row = AddEmptyRow(*m_bodyA, m_linkA, rows, data);
  row.m_orgConstraint = this;
  row.m_orgDofIndex = wanted.index;
  row.m_jacAindex = response.at;
  row.m_rhs = wanted.target_velocity - response.velocity;
  row.m_cfm = wanted.softness;
  row.m_lowerLimit = wanted.lowest;
  row.m_upperLimit = wanted.highest;
}

MotorRow::MotorRow(RobotBody& robot, int dof, const Traits& traits)
    : JointSpaceConstraint(robot, robot.members(dof).front().joint, 4), members_(robot.members(dof)), traits_(traits) {
  for (const RobotBody::Member& member : members_) AddTerm(robot.Row(member.joint), member.share);
}

double MotorRow::Position() const {
  double position = 0.0;
  for (const RobotBody::Member& member : members_) {
    position += member.share * (m_bodyA->getJointPos(member.joint) - member.offset);
  }
  return position;
}

double MotorRow::Rate() const {
  double rate = 0.0;
  for (const RobotBody::Member& member : members_) rate += member.share * m_bodyA->getJointVel(member.joint);
  return rate;
}

void MotorRow::SetTarget(const Target& target) {
  target_ = target;
  start_rate_ = Rate();
}

void MotorRow::createConstraintRows(btMultiBodyConstraintArray& rows, btMultiBodyJacobianData& data,
                                    const btContactSolverInfo& info) {
  const double h = info.m_timeStep, q = Position(), velocity = Rate();
  const double drive = traits_.torque_scale * (h * h * target_.stiffness + h * target_.damping);
  driven_ = drive > 0.0;
  std::optional<Response> response;
  if (driven_ || traits_.drags() || traits_.friction > 0.0) response = Respond(data);
  double gain = 0.0;  // velocity that the motor may add in the step
  if (driven_) {
    const double pull = target_.over_limit + target_.stiffness * (target_.q - q) + target_.damping * target_.v;
    const double target_velocity = traits_.torque_scale * h * pull / drive;
    const double lowest = traits_.torque_scale * h * (target_.limits.lowest - target_.tau_ff);
    const double highest = traits_.torque_scale * h * (target_.limits.highest - target_.tau_ff);
    AddRow({kDrive, target_velocity, 1.0 / drive, std::max(-kUnlimited, lowest), std::min(kUnlimited, highest)},
           *response, rows, data);
    const double most = std::min(target_.limits.largest(), std::abs(pull) + target_.damping * std::abs(velocity));
    gain = traits_.torque_scale * InverseInertia() * h * most;
  }
  if (target_.from_transmission > 0.0) gain = traits_.torque_scale * InverseInertia() * h * target_.from_transmission;
  if (response) AddLosses(h, *response, rows, data);
  // A stop acts only if the coming step could pass it.
  const double carried = traits_.rotor_inertia > 0.0 ? std::abs(start_rate_) : 0.0;
  const double reach = 2.0 * h * (std::max(std::abs(velocity), carried) + gain);
  const double lowest_rate = (traits_.lower - q) / h, highest_rate = (traits_.upper - q) / h;
  if (q - reach < traits_.lower) AddRow({kStop, lowest_rate, 0.0, 0.0, kUnlimited}, Respond(data), rows, data);
  if (q + reach > traits_.upper) AddRow({kStop, highest_rate, 0.0, -kUnlimited, 0.0}, Respond(data), rows, data);
}

void MotorRow::AddLosses(double step_s, const Response& response, btMultiBodyConstraintArray& rows,
                         btMultiBodyJacobianData& data) {
  const double drag = traits_.rotor_inertia + step_s * traits_.damping, grip = step_s * traits_.friction;
  if (drag > 0.0) {
    const double carried = traits_.rotor_inertia * start_rate_;
    AddRow({kLoss, carried / drag, 1.0 / drag, -kUnlimited, kUnlimited}, response, rows, data);
  }
  if (grip > 0.0) AddRow({kDryFriction, 0.0, 0.0, -grip, grip}, response, rows, data);
}

double MotorRow::Torque(double step_s) {
  const double row = driven_ ? getAppliedImpulse(kDrive) / step_s / traits_.torque_scale : 0.0;
  return std::clamp(target_.tau_ff + row, target_.limits.lowest, target_.limits.highest);
}

GearRow::GearRow(RobotBody& robot, const Joint& joint, int follower, int leader)
    : JointSpaceConstraint(robot, follower, 1),
      follower_(follower),
      leader_(leader),
      multiplier_(joint.multiplier),
      offset_(joint.offset) {
  AddTerm(robot.Row(follower), 1.0);
  AddTerm(robot.Row(leader), -joint.multiplier);
}

double GearRow::Error() const {
  return m_bodyA->getJointPos(follower_) - multiplier_ * m_bodyA->getJointPos(leader_) - offset_;
}

void GearRow::createConstraintRows(btMultiBodyConstraintArray& rows, btMultiBodyJacobianData& data,
                                   const btContactSolverInfo& info) {
  const double target = -kGearCorrection * Error() / info.m_timeStep;
  AddRow({0, target, 0.0, -kUnlimited, kUnlimited}, Respond(data), rows, data);
}

}  // namespace gaitwright::bullet
