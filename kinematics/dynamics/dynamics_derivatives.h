// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "kinematics/dynamics/dynamics.h"

namespace gaitwright {

/// Inverse dynamics and its derivatives, all of size nv or nv x nv.
///
/// Columns of `by_q` are along the same directions as v: base origin in W [m], rotation of the base by a small vector
/// in W [rad], joints; the elements of v and a stay constant. M is the derivative by `a`. The first three columns of
/// `by_q` and `by_v` are zero, because tau does not depend on position and velocity of the base origin.
struct InverseDynamicsDerivatives {
  VectorX tau;         ///< as in InverseDynamics
  MatrixX by_q, by_v;  ///< derivatives of tau
  MatrixX M;           ///< as in MassMatrix
};

/// Derivatives of the velocity and the acceleration [linear; angular] of a point fixed in a body, each of size 6 x nv,
/// along the same directions. The derivatives of the velocity by v and of the acceleration by a are PointJacobian.
struct PointDerivatives {
  MatrixX velocity_by_q, acceleration_by_q, acceleration_by_v;
};

/// Centroidal momentum (as in CentroidalMomentum) and its derivatives, each of size 6 x nv.
struct MomentumDerivatives {
  Vector6 momentum;
  MatrixX by_q;
  MatrixX by_v;  ///< the centroidal momentum matrix: Orin, Goswami and Lee, Autonomous Robots, 2013
};

/// Analytic derivatives of InverseDynamics. An object works for one model and in one thread at a time. Only its first
/// call allocates memory.
///
/// The cost is O(n d) for n joints and a tree of depth d. Formulas: Carpentier and Mansard, Analytical derivatives of
/// rigid body dynamics algorithms, RSS 2018, in the form of Singh, Russo and Wensing, Efficient analytical derivatives
/// of rigid-body dynamics using spatial vector algebra, RA-L 2022. Derivatives by the base's rotation follow from the
/// invariance of the dynamics under rotations of the world together with gravity.
class DynamicsDerivatives {
 public:
  /// The model must outlive this object.
  explicit DynamicsDerivatives(const RobotModel& model);
  ~DynamicsDerivatives();

  /// Computes `result` at q (nq), v (nv), a (nv); the vectors must have these sizes.
  void Compute(const VectorX& q, const VectorX& v, const VectorX& a, InverseDynamicsDerivatives& result);

  /// Derivatives of a point fixed in a body, in the state of the last call of Compute.
  void DifferentiatePoint(int body, const Vector3& p_BQ, PointDerivatives& result) const;
  /// Derivatives of the robot's momentum, in the state of the last call of Compute.
  void DifferentiateMomentum(MomentumDerivatives& result) const;

  /// Kinematics of the last call of Compute: poses, not velocities.
  const DynamicsScratch& kinematics() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace gaitwright
