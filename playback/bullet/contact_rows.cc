// SPDX-License-Identifier: BSD-3-Clause
#include <BulletDynamics/Featherstone/btMultiBodyLinkCollider.h>

#include <algorithm>

#include "playback/bullet/contact_rows_internal.h"
#include "playback/bullet/robot_body_internal.h"

namespace gaitwright::bullet {
namespace {

constexpr double kUnlimitedPush = 1e10;  // impulse

/// A contact point, seen from the robot.
struct TouchingPoint {
  btManifoldPoint& point;
  const btMultiBodyLinkCollider& collider;
  double sign;  ///< of normals and impulses; a manifold gives them for its first body
  Vector3 p_W;
};

/// A row that requires zero velocity along a direction.
btMultiBodySolverConstraint& AddRowAlong(const TouchingPoint& touching, const btVector3& direction,
                                         const JointSpaceInertia& inertia, btMultiBodyConstraintArray& rows,
                                         btMultiBodyJacobianData& data) {
  btMultiBody& body = *touching.collider.m_multiBody;
  btMultiBodySolverConstraint& row = AddEmptyRow(body, touching.collider.m_link, rows, data);
  row.m_originalContactPoint = &touching.point;
  row.m_friction = touching.point.m_combinedFriction;
  row.m_jacAindex = AddJacobian(inertia.size(), data);
  double* J = &data.m_jacobians[row.m_jacAindex];
  inertia.FillPointJacobian(touching.collider.m_link, touching.p_W, touching.sign * FromBullet(direction), J);
  const Eigen::Map<const VectorX> along(J, inertia.size()), velocity(body.getVelocityVector(), inertia.size());
  row.m_rhs = -along.dot(velocity);
  return row;
}

void AddRowsOfPoint(const TouchingPoint& touching, const JointSpaceInertia& inertia, const btContactSolverInfo& info,
                    const SolverRows& rows) {
  btManifoldPoint& point = touching.point;
  const double h = info.m_timeStep, distance = point.getDistance() + info.m_linearSlop;
  const int normal_at = rows.normals.size();
  auto& normal = AddRowAlong(touching, point.m_normalWorldOnB, inertia, rows.normals, rows.data);
  normal.m_rhs -= (distance > 0.0 ? 1.0 : info.m_erp2) * distance / h;
  normal.m_cfm = info.m_globalCfm / h;
  normal.m_lowerLimit = 0.0;
  normal.m_upperLimit = kUnlimitedPush;
  normal.m_frictionIndex = rows.frictions.size();

  btPlaneSpace1(point.m_normalWorldOnB, point.m_lateralFrictionDir1, point.m_lateralFrictionDir2);
  for (btVector3* direction : {&point.m_lateralFrictionDir1, &point.m_lateralFrictionDir2}) {
    direction->normalize();
    auto& friction = AddRowAlong(touching, *direction, inertia, rows.frictions, rows.data);
    friction.m_cfm = info.m_frictionCFM / h;
    friction.m_lowerLimit = -point.m_combinedFriction;
    friction.m_upperLimit = point.m_combinedFriction;
    friction.m_frictionIndex = normal_at;
  }
}

}  // namespace

void AddContactRows(btPersistentManifold& manifold, const JointSpaceInertia& inertia, const btContactSolverInfo& info,
                    const SolverRows& rows) {
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
  row.m_jacDiagABInv = 1.0;
  row.m_rhs = row.m_cfm = 0.0;
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

void NormaliseRows(const JointSpaceInertia& inertia, const SolverRows& rows) {
  btMultiBodyJacobianData& data = rows.data;
  const Eigen::Index n = inertia.size();
  data.m_deltaVelocitiesUnitImpulse = data.m_jacobians;
  for (int at = 0; at < data.m_jacobians.size(); at += inertia.size()) {
    inertia.factor().SolveUpper(&data.m_deltaVelocitiesUnitImpulse[at]);
    inertia.factor().SolveLower(&data.m_deltaVelocitiesUnitImpulse[at]);
  }
  for (btMultiBodyConstraintArray* some : {&rows.joints, &rows.normals, &rows.frictions}) {
    for (int i = 0; i < some->size(); ++i) {
      btMultiBodySolverConstraint& row = (*some)[i];
      const Eigen::Map<const VectorX> J(&data.m_jacobians[row.m_jacAindex], n);
      const Eigen::Map<const VectorX> response(&data.m_deltaVelocitiesUnitImpulse[row.m_jacAindex], n);
      row.m_jacDiagABInv = 1.0 / (J.dot(response) + row.m_cfm);
      row.m_rhs *= row.m_jacDiagABInv;
      row.m_cfm *= row.m_jacDiagABInv;
    }
  }
}

}  // namespace gaitwright::bullet
