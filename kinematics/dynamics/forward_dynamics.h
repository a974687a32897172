// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "kinematics/dynamics/dynamics.h"

namespace gaitwright {

/// Forward dynamics of one model for one thread; after the first call it does not allocate.
///
/// Articulated bodies, O(n): Featherstone, Rigid Body Dynamics Algorithms, 2008, section 7.3. Mimic joints are tied to
/// their leaders by constraint forces that do no work, found by one more propagation for each of them.
class ForwardDynamics {
 public:
  /// The model must outlive this.
  explicit ForwardDynamics(const RobotModel& model);
  ~ForwardDynamics();

  /// Accelerations a (size nv) with M(q) a + h(q, v) = tau, the inverse of InverseDynamics.
  /// @param tau  generalised forces (size nv): wrench on the base about its origin in W, then joints; contact forces
  /// enter through their Jacobian.
  /// @param rotor_inertia  by independent joint, seen at the joint (size n) [kg m^2]; empty for none.
  /// @throws InvalidArgument if a joint moves nothing that has inertia.
  void Compute(const VectorX& q, const VectorX& v, const VectorX& tau, VectorX& a,
               const VectorX& rotor_inertia = VectorX());

  /// Kinematics of the last call: poses, not velocities.
  const DynamicsScratch& kinematics() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace gaitwright
