// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>
#include <BulletDynamics/Featherstone/btMultiBodyConstraint.h>

#include "playback/bullet/joint_space_inertia_internal.h"

namespace gaitwright::bullet {

/// Where rows go.
struct ContactRows {
  btMultiBodyConstraintArray& normals;
  btMultiBodyConstraintArray& frictions;  ///< two for each normal
  btMultiBodyJacobianData& data;
};

/// Rows of the contacts of a multibody with ground that never moves. They ask what btMultiBodyConstraintSolver asks for
/// the same points, with two directions of friction and without restitution, which nothing here has: with v the
/// velocity along the normal under all forces but those of rows, h the step, d the distance and p the impulse,
///   v + J M^-1 J^T p + cfm / h p = -d / h apart, -erp2 d / h in the ground, p >= 0.
/// J is made along the path of the link and J M^-1 J^T from the factor of M, by which a row costs a tenth of Bullet's.
/// M^-1 J^T is not made: see FillResponses.
void AddContactRows(btPersistentManifold& manifold, JointSpaceInertia& inertia, const btContactSolverInfo& info,
                    const ContactRows& rows);

/// A row of a multibody, without values: at the end of `rows`, with the index of the body's change of velocity in the
/// arrays of `data`, which is new to them with the first row of a step.
btMultiBodySolverConstraint& AddEmptyRow(btMultiBody& body, int link, btMultiBodyConstraintArray& rows,
                                         btMultiBodyJacobianData& data);

/// Room for one more J in the arrays of `data`, all zero. @return where it begins.
int AddJacobian(int size, btMultiBodyJacobianData& data);

/// M^-1 J^T of all rows in the arrays of `data`, which only Bullet's own iterations need.
void FillResponses(const JointSpaceInertia& inertia, btMultiBodyJacobianData& data);

}  // namespace gaitwright::bullet
