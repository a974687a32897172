// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>
#include <BulletDynamics/Featherstone/btMultiBodyConstraint.h>

#include "playback/bullet/joint_space_inertia_internal.h"

namespace gaitwright::bullet {

/// Bullet's arrays that rows go into. Rows are kept unscaled, J qd + m_cfm * impulse = J qd + m_rhs, with
/// m_jacDiagABInv 1, and without M^-1 J^T: see NormaliseRows.
struct SolverRows {
  btMultiBodyConstraintArray& joints;
  btMultiBodyConstraintArray& normals;
  btMultiBodyConstraintArray& frictions;  ///< two for each normal
  btMultiBodyJacobianData& data;
};

/// Rows of the contacts of a multibody with ground that never moves. They ask what btMultiBodyConstraintSolver asks for
/// the same points, with two directions of friction and without restitution and over-relaxation, which nothing here
/// has: with v the velocity along the normal after the step, h the step, d the distance and p >= 0 the impulse,
///   v + cfm / h p = -d / h apart, -erp2 d / h in the ground.
/// J is made along the path of the link only.
void AddContactRows(btPersistentManifold& manifold, const JointSpaceInertia& inertia, const btContactSolverInfo& info,
                    const SolverRows& rows);

/// A row of a multibody, without values: at the end of `rows`, with the index of the body's change of velocity in the
/// arrays of `data`, which is new to them with the first row of a step.
btMultiBodySolverConstraint& AddEmptyRow(btMultiBody& body, int link, btMultiBodyConstraintArray& rows,
                                         btMultiBodyJacobianData& data);

/// Room for one more J in the arrays of `data`, all zero. @return where it begins.
int AddJacobian(int size, btMultiBodyJacobianData& data);

/// Scales rows by 1 / (J M^-1 J^T + m_cfm) and makes M^-1 J^T, as Bullet's own iterations need them.
void NormaliseRows(const JointSpaceInertia& inertia, const SolverRows& rows);

}  // namespace gaitwright::bullet
