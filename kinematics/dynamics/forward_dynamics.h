// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "kinematics/dynamics/dynamics.h"

namespace gaitwright {

/// Forward dynamics of one model for one thread. Only the first call allocates memory.
///
/// Articulated bodies, O(n): Featherstone, Rigid Body Dynamics Algorithms, 2008, section 7.3. Constraint forces, which
/// do no work, couple mimic joints to their leaders; each mimic joint needs one more propagation.
class ForwardDynamics {
 public:
  /// The model must outlive this object.
  explicit ForwardDynamics(const RobotModel& model);
  ~ForwardDynamics();

  /// Accelerations a (size nv) with M(q) a + h(q, v) = tau, the inverse of InverseDynamics.
  /// @param tau  generalised forces (size nv): wrench on the base about its origin in W, then joints; contact forces
  /// enter through their Jacobian.
  /// @param rotor_inertia  by independent joint, reflected to the joint (size n) [kg m^2]; empty for no rotors.
  /// @throws InvalidArgument if the bodies that a joint moves have no inertia.
  void Compute(const VectorX& q, const VectorX& v, const VectorX& tau, VectorX& a,
               const VectorX& rotor_inertia = VectorX());

  /// Kinematics of the last call of Compute: poses, not velocities.
  const DynamicsScratch& kinematics() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace gaitwright
