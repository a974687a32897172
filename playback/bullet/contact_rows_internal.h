// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>
#include <BulletDynamics/Featherstone/btMultiBodyConstraint.h>

#include "playback/bullet/joint_space_inertia_internal.h"

namespace gaitwright::bullet {

/// Bullet's arrays for the rows. Rows are stored unscaled, J qd + m_cfm * impulse = J qd + m_rhs, with m_jacDiagABInv 1
/// and without M^-1 J^T (NormaliseRows).
struct SolverRows {
  btMultiBodyConstraintArray& joints;
  btMultiBodyConstraintArray& normals;
  btMultiBodyConstraintArray& frictions;  ///< two for each normal
  btMultiBodyJacobianData& data;
};

/// Adds the contact rows of a multibody on static ground. The conditions are those of btMultiBodyConstraintSolver with
/// two friction directions, and without restitution and over-relaxation. With v the normal velocity after the step, h
/// the step, d the distance and p >= 0 the impulse:
///   v + cfm / h p = -d / h if apart, -erp2 d / h in penetration.
/// J has entries only along the path of the link.
void AddContactRows(btPersistentManifold& manifold, const JointSpaceInertia& inertia, const btContactSolverInfo& info,
                    const SolverRows& rows);

/// Appends a row of a multibody without values to `rows`. The row has the index of the body's velocity change in the
/// arrays of `data`; the first row of a step adds this entry.
btMultiBodySolverConstraint& AddEmptyRow(btMultiBody& body, int link, btMultiBodyConstraintArray& rows,
                                         btMultiBodyJacobianData& data);

/// Reserves one more J, all zero, in the arrays of `data`. @return its start index.
int AddJacobian(int size, btMultiBodyJacobianData& data);

/// Scales rows by 1 / (J M^-1 J^T + m_cfm) and computes M^-1 J^T, as Bullet's own iterations require.
void NormaliseRows(const JointSpaceInertia& inertia, const SolverRows& rows);

}  // namespace gaitwright::bullet
