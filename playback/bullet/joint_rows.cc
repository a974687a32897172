// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

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

double JointSpaceConstraint::AddRow(const Row& wanted, btMultiBodyConstraintArray& rows,
                                    btMultiBodyJacobianData& data) {
  const int n = 6 + m_bodyA->getNumDofs();
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
    data.m_deltaVelocities.resize(row.m_deltaVelAindex + n);
  }
  row.m_jacAindex = data.m_jacobians.size();
  data.m_jacobians.resize(row.m_jacAindex + n);
  data.m_deltaVelocitiesUnitImpulse.resize(row.m_jacAindex + n);
  btScalar* J = &data.m_jacobians[row.m_jacAindex];
  btScalar* response = &data.m_deltaVelocitiesUnitImpulse[row.m_jacAindex];
  std::copy(jacobian_.begin(), jacobian_.end(), J);
  m_bodyA->calcAccelerationDeltasMultiDof(J, response, data.scratch_r, data.scratch_v);

  double inertia_inverse = 0.0, velocity = 0.0;
  for (int i = 6; i < n; ++i) {
    inertia_inverse += J[i] * response[i];
    velocity += J[i] * m_bodyA->getVelocityVector()[i];
  }
  row.m_jacDiagABInv = 1.0 / (inertia_inverse + wanted.softness);
  row.m_rhs = (wanted.target_velocity - velocity) * row.m_jacDiagABInv;
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
  return inertia_inverse;
}

MotorRow::MotorRow(const RobotBody& robot, btMultiBody& body, int dof, const Limits& limits)
    : JointSpaceConstraint(body, robot.members(dof).front().joint, 2), members_(robot.members(dof)), limits_(limits) {
  for (const RobotBody::Member& member : members_) AddTerm(robot.Row(member.joint), member.share);
}

double MotorRow::Position() const {
  double position = 0.0;
  for (const RobotBody::Member& member : members_) {
    position += member.share * (m_bodyA->getJointPos(member.joint) - member.offset);
  }
  return position;
}

void MotorRow::createConstraintRows(btMultiBodyConstraintArray& rows, btMultiBodyJacobianData& data,
                                    const btContactSolverInfo& info) {
  const double h = info.m_timeStep, q = Position();
  const double drive = h * h * target_.stiffness + h * target_.damping;
  driven_ = drive > 0.0;
  double velocity = 0.0, gain = 0.0;  // what the motor may add to it in the step
  for (const RobotBody::Member& member : members_) velocity += member.share * m_bodyA->getJointVel(member.joint);
  if (driven_) {
    const double pull = target_.excess + target_.stiffness * (target_.q - q) + target_.damping * target_.v;
    const double lowest = std::max(-kUnlimited, h * (-limits_.effort - target_.tau_ff));
    const double highest = std::min(kUnlimited, h * (limits_.effort - target_.tau_ff));
    const double response = AddRow({kDrive, h * pull / drive, 1.0 / drive, lowest, highest}, rows, data);
    gain = response * h * std::min(limits_.effort, std::abs(pull) + target_.damping * std::abs(velocity));
  }
  // A stop acts only when the coming step could pass it.
  const double reach = 2.0 * h * (std::abs(velocity) + gain);
  if (q - reach < limits_.lower) AddRow({kStop, (limits_.lower - q) / h, 0.0, 0.0, kUnlimited}, rows, data);
  if (q + reach > limits_.upper) AddRow({kStop, (limits_.upper - q) / h, 0.0, -kUnlimited, 0.0}, rows, data);
}

double MotorRow::Torque(double step_s) {
  const double total = target_.tau_ff + (driven_ ? getAppliedImpulse(kDrive) / step_s : 0.0);
  return std::clamp(total, -limits_.effort, limits_.effort);
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
  AddRow({0, -kGearCorrection * Error() / info.m_timeStep, 0.0, -kUnlimited, kUnlimited}, rows, data);
}

}  // namespace gaitwright::bullet
