// SPDX-License-Identifier: BSD-3-Clause
#include <BulletDynamics/Featherstone/btMultiBodyLinkCollider.h>

#include "playback/bullet/contact_rows_internal.h"
#include "playback/bullet/robot_body_internal.h"

namespace gaitwright::bullet {
namespace {

constexpr double kUnlimitedPush = 1e10;  // impulse

/// A contact as the robot sees it.
struct TouchingPoint {
  btManifoldPoint& point;
  const btMultiBodyLinkCollider& collider;
  double sign;  ///< of normals and impulses, which are given for the first body of a manifold
  Vector3 p_W;
};

/// A row without values, and what they are made of.
struct RowAlong {
  btMultiBodySolverConstraint& row;
  double inverse_inertia;  ///< J M^-1 J^T
  double velocity;         ///< J qd

  /// J qd + softness * impulse = target
  void Ask(double target, double softness, double relaxation) {
    row.m_jacDiagABInv = relaxation / (inverse_inertia + softness);
    row.m_rhs = (target - velocity) * row.m_jacDiagABInv;
    row.m_cfm = softness * row.m_jacDiagABInv;
  }
  void Bound(double lowest, double highest) {
    row.m_lowerLimit = lowest;
    row.m_upperLimit = highest;
  }
};

RowAlong AddRowAlong(const TouchingPoint& touching, const btVector3& direction, JointSpaceInertia& inertia,
                     btMultiBodyConstraintArray& rows, btMultiBodyJacobianData& data) {
  btMultiBody& body = *touching.collider.m_multiBody;
  btMultiBodySolverConstraint& row = AddEmptyRow(body, touching.collider.m_link, rows, data);
  row.m_originalContactPoint = &touching.point;
  row.m_friction = touching.point.m_combinedFriction;
  row.m_jacAindex = AddJacobian(inertia.size(), data);
  double* J = &data.m_jacobians[row.m_jacAindex];
  inertia.FillPointJacobian(touching.collider.m_link, touching.p_W, touching.sign * FromBullet(direction), J);
  const Eigen::Map<const VectorX> along(J, inertia.size()), velocity(body.getVelocityVector(), inertia.size());
  return {row, inertia.InverseAlong(J), along.dot(velocity)};
}

void AddRowsOfPoint(const TouchingPoint& touching, JointSpaceInertia& inertia, const btContactSolverInfo& info,
                    const ContactRows& rows) {
  btManifoldPoint& point = touching.point;
  const double h = info.m_timeStep, distance = point.getDistance() + info.m_linearSlop;
  const int normal_at = rows.normals.size(), frictions_at = rows.frictions.size();
  RowAlong normal = AddRowAlong(touching, point.m_normalWorldOnB, inertia, rows.normals, rows.data);
  normal.Ask(-(distance > 0.0 ? 1.0 : info.m_erp2) * distance / h, info.m_globalCfm / h, info.m_sor);
  normal.Bound(0.0, kUnlimitedPush);
  normal.row.m_frictionIndex = frictions_at;

  btPlaneSpace1(point.m_normalWorldOnB, point.m_lateralFrictionDir1, point.m_lateralFrictionDir2);
  for (btVector3* direction : {&point.m_lateralFrictionDir1, &point.m_lateralFrictionDir2}) {
    direction->normalize();
    RowAlong friction = AddRowAlong(touching, *direction, inertia, rows.frictions, rows.data);
    friction.Ask(0.0, info.m_frictionCFM / h, info.m_sor);
    friction.Bound(-point.m_combinedFriction, point.m_combinedFriction);
    friction.row.m_frictionIndex = normal_at;
  }
}

}  // namespace

void AddContactRows(btPersistentManifold& manifold, JointSpaceInertia& inertia, const btContactSolverInfo& info,
                    const ContactRows& rows) {
  const auto* first = btMultiBodyLinkCollider::upcast(manifold.getBody0());
  const auto* collider = first != nullptr ? first : btMultiBodyLinkCollider::upcast(manifold.getBody1());
  if (collider == nullptr) return;
  for (int i = 0; i < manifold.getNumContacts(); ++i) {
    btManifoldPoint& point = manifold.getContactPoint(i);
    if (point.getDistance() > manifold.getContactProcessingThreshold()) continue;
    const Vector3 p_W = FromBullet(first != nullptr ? point.getPositionWorldOnA() : point.getPositionWorldOnB());
    AddRowsOfPoint({point, *collider, first != nullptr ? 1.0 : -1.0, p_W}, inertia, info, rows);
  }
}

btMultiBodySolverConstraint& AddEmptyRow(btMultiBody& body, int link, btMultiBodyConstraintArray& rows,
                                         btMultiBodyJacobianData& data) {
  btMultiBodySolverConstraint& row = rows.expandNonInitializing();
  row = btMultiBodySolverConstraint();
  row.m_multiBodyA = &body;
  row.m_linkA = link;
  row.m_deltaVelAindex = body.getCompanionId();
  if (row.m_deltaVelAindex < 0) {
    row.m_deltaVelAindex = data.m_deltaVelocities.size();
    body.setCompanionId(row.m_deltaVelAindex);
    data.m_deltaVelocities.resize(row.m_deltaVelAindex + 6 + body.getNumDofs());
  }
  row.m_appliedImpulse = row.m_appliedPushImpulse = row.m_rhsPenetration = row.m_friction = 0.0;
  for (btVector3* part : {&row.m_relpos1CrossNormal, &row.m_contactNormal1, &row.m_relpos2CrossNormal,
                          &row.m_contactNormal2, &row.m_angularComponentA, &row.m_angularComponentB}) {
    part->setZero();
  }
  row.m_originalContactPoint = nullptr;
  row.m_frictionIndex = row.m_overrideNumSolverIterations = row.m_deltaVelBindex = row.m_jacBindex = 0;
  return row;
}

int AddJacobian(int size, btMultiBodyJacobianData& data) {
  const int at = data.m_jacobians.size();
  data.m_jacobians.resize(at + size);
  std::fill_n(&data.m_jacobians[at], size, 0.0);
  return at;
}

void FillResponses(const JointSpaceInertia& inertia, btMultiBodyJacobianData& data) {
  data.m_deltaVelocitiesUnitImpulse = data.m_jacobians;
  for (int at = 0; at < data.m_jacobians.size(); at += inertia.size()) {
    inertia.factor().SolveUpper(&data.m_deltaVelocitiesUnitImpulse[at]);
    inertia.factor().SolveLower(&data.m_deltaVelocitiesUnitImpulse[at]);
  }
}

}  // namespace gaitwright::bullet
