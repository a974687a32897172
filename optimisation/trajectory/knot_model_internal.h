// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/dynamics/dynamics_derivatives.h"

namespace gaitwright {

/// A foot that presses on the ground at one time.
///
/// = Notation =
///   F  the foot's frame (Foot); Q a point through which the ground pushes: p_WQ = p_WF + R_WF p_FQ + offset_W
struct KnotContact {
  int foot = 0;
  std::vector<Vector3> points_F = {Vector3::Zero()};  ///< corners of a sole [m]; the origin of a point or sphere
  Vector3 offset_W = Vector3::Zero();                 ///< of a sphere: minus its radius along the ground's normal [m]
};

/// What forces at the contacts leave open of the motion: generalised forces that bodies need, less those of contacts.
///
/// The first six are the wrench on the base about its origin in W that nothing gives: zero for a motion that is
/// dynamically consistent. The others are the torques of the independent joints.
///
/// Derivatives are along the same directions as v, as of InverseDynamicsDerivatives; those by forces have three columns
/// for each point of each contact, in order.
struct KnotForces {
  VectorX needed;                          ///< size nv [N, N m]
  MatrixX by_q, by_v, by_a;                ///< nv x nv
  Eigen::Matrix<double, -1, -1> by_force;  ///< nv x 3 points
};

/// Position and rotation of a foot's frame F, with the Jacobian [linear; angular] by v, size 6 x nv.
struct KnotFoot {
  Vector3 p_WF = Vector3::Zero();
  Matrix3 R_WF = Matrix3::Identity();
  MatrixX J;
};

/// Dynamics and kinematics of a robot at one time, with exact derivatives. After the first calls it does not allocate.
class KnotModel {
 public:
  /// The model must outlive this.
  explicit KnotModel(const RobotModel& model);

  /// KnotForces::needed alone, size nv. @param forces_W  three for each point of each contact [N].
  void Evaluate(const VectorX& q, const VectorX& v, const VectorX& a, const std::vector<KnotContact>& contacts,
                const Eigen::Ref<const VectorX>& forces_W, VectorX& needed);
  /// The same with derivatives.
  void Differentiate(const VectorX& q, const VectorX& v, const VectorX& a, const std::vector<KnotContact>& contacts,
                     const Eigen::Ref<const VectorX>& forces_W, KnotForces& result);

  /// A foot after either call; `J` only where asked for.
  void FootAt(int foot, bool with_jacobian, KnotFoot& result) const;

  /// Acceleration [linear of the base's origin; angular] in W that a wrench on the base about its origin gives to the
  /// robot at rest with its joints locked, after either call; and the reverse.
  Vector6 LockedAcceleration(const Vector6& wrench_W) const;
  Vector6 LockedWrench(const Vector6& acceleration_W) const;

  const RobotModel& model() const { return model_; }
  /// Poses and axes, after either call.
  const DynamicsScratch& kinematics() const { return differentiated_ ? derivatives_.kinematics() : scratch_; }

 private:
  void AddContact(const KnotContact& contact, const Eigen::Ref<const VectorX>& forces_W, VectorX& needed) const;
  void AddContactDerivatives(const KnotContact& contact, const Eigen::Ref<const VectorX>& forces_W, Eigen::Index column,
                             KnotForces& result);
  const std::vector<int>& ChainOf(int foot) const { return chain_[static_cast<std::size_t>(foot)]; }

  const RobotModel& model_;
  DynamicsScratch scratch_;
  DynamicsDerivatives derivatives_;
  InverseDynamicsDerivatives of_bodies_;
  bool differentiated_ = false;          // where the last call left its kinematics
  std::vector<std::vector<int>> chain_;  // by foot: joints from the base to it
  MatrixX foot_J_;
};

}  // namespace gaitwright
