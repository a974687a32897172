// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <optional>

#include "playback/bullet/joint_rows_internal.h"

namespace gaitwright::bullet {
namespace {

constexpr double kUnlimited = 1e30;      // impulse
constexpr double kGearCorrection = 0.5;  // share of a gear's error that a step takes back

}  // namespace

JointSpaceConstraint::JointSpaceConstraint(btMultiBody& body, int link, int rows)
    : btMultiBodyConstraint(&body, nullptr, link, -1, rows, false, MULTIBODY_CONSTRAINT_1DOF_JOINT_MOTOR),
      jacobian_(static_cast<std::size_t>(6 + body.getNumDofs()), 0.0) {
  m_data.resize(rows);
}

int JointSpaceConstraint::getIslandIdA() const { return m_bodyA->getBaseCollider()->getIslandTag(); }

void JointSpaceConstraint::AddTerm(int dof_row, double coefficient) {
  jacobian_.at(static_cast<std::size_t>(6 + dof_row)) += coefficient;
}

JointSpaceConstraint::Response JointSpaceConstraint::Respond(btMultiBodyJacobianData& data) {
  const int n = 6 + m_bodyA->getNumDofs(), at = data.m_jacobians.size();
  data.m_jacobians.resize(at + n);
  data.m_deltaVelocitiesUnitImpulse.resize(at + n);
  btScalar* J = &data.m_jacobians[at];
  btScalar* response = &data.m_deltaVelocitiesUnitImpulse[at];
  std::copy(jacobian_.begin(), jacobian_.end(), J);
  m_bodyA->calcAccelerationDeltasMultiDof(J, response, data.scratch_r, data.scratch_v);
  Response result{at, 0.0, 0.0};
  for (int i = 6; i < n; ++i) {
    result.inverse_inertia += J[i] * response[i];
    result.velocity += J[i] * m_bodyA->getVelocityVector()[i];
  }
  return result;
}

void JointSpaceConstraint::AddRow(const Row& wanted, const Response& response, btMultiBodyConstraintArray& rows,
                                  btMultiBodyJacobianData& data) {
  btMultiBodySolverConstraint& row = rows.expandNonInitializing();
  row = btMultiBodySolverConstraint();
  row.m_orgConstraint = this;
  row.m_orgDofIndex = wanted.index;
  row.m_multiBodyA = m_bodyA;
  row.m_linkA = m_linkA;
  row.m_deltaVelAindex = m_bodyA->getCompanionId();
  if (row.m_deltaVelAindex < 0) {
    row.m_deltaVelAindex = data.m_deltaVelocities.size();
    m_bodyA->setCompanionId(row.m_deltaVelAindex);
    data.m_deltaVelocities.resize(row.m_deltaVelAindex + 6 + m_bodyA->getNumDofs());
  }
  row.m_jacAindex = response.at;
  row.m_jacDiagABInv = 1.0 / (response.inverse_inertia + wanted.softness);
  row.m_rhs = (wanted.target_velocity - response.velocity) * row.m_jacDiagABInv;
  row.m_cfm = wanted.softness * row.m_jacDiagABInv;
  row.m_lowerLimit = wanted.lowest;
  row.m_upperLimit = wanted.highest;
  row.m_appliedImpulse = row.m_appliedPushImpulse = row.m_rhsPenetration = row.m_friction = 0.0;
  for (btVector3* part : {&row.m_relpos1CrossNormal, &row.m_contactNormal1, &row.m_relpos2CrossNormal,
                          &row.m_contactNormal2, &row.m_angularComponentA, &row.m_angularComponentB}) {
    part->setZero();
  }
  row.m_originalContactPoint = nullptr;
  row.m_frictionIndex = row.m_overrideNumSolverIterations = row.m_deltaVelBindex = row.m_jacBindex = 0;
}

MotorRow::MotorRow(const RobotBody& robot, btMultiBody& body, int dof, const Traits& traits)
    : JointSpaceConstraint(body, robot.members(dof).front().joint, 4), members_(robot.members(dof)), traits_(traits) {
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
  if (driven_ || target_.from_transmission > 0.0 || traits_.drags() || traits_.friction > 0.0) response = Respond(data);
  double gain = 0.0;  // what the motor may add to the velocity in the step
  if (driven_) {
    const double pull = target_.excess + target_.stiffness * (target_.q - q) + target_.damping * target_.v;
    const double target_velocity = traits_.torque_scale * h * pull / drive;
    const double lowest = traits_.torque_scale * h * (target_.limits.lowest - target_.tau_ff);
    const double highest = traits_.torque_scale * h * (target_.limits.highest - target_.tau_ff);
    AddRow({kDrive, target_velocity, 1.0 / drive, std::max(-kUnlimited, lowest), std::min(kUnlimited, highest)},
           *response, rows, data);
    const double most = std::min(target_.limits.largest(), std::abs(pull) + target_.damping * std::abs(velocity));
    gain = traits_.torque_scale * response->inverse_inertia * h * most;
  }
  if (target_.from_transmission > 0.0)
    gain = traits_.torque_scale * response->inverse_inertia * h * target_.from_transmission;
  if (response) AddLosses(h, *response, rows, data);
  // A stop acts only when the coming step could pass it.
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

GearRow::GearRow(const RobotBody& robot, btMultiBody& body, const Joint& joint, int follower, int leader)
    : JointSpaceConstraint(body, follower, 1),
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
