// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/dynamics/forward_dynamics.h"

#include <fmt/format.h>

#include "kinematics/base/result.h"
#include "kinematics/dynamics/spatial_internal.h"

namespace gaitwright {
namespace {

using spatial::Cross, spatial::Motion, spatial::Stacked;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

Matrix6 DenseInertia(const spatial::Inertia& I) {
  Matrix6 dense;
  dense.topLeftCorner<3, 3>() = I.mass * Matrix3::Identity();
  dense.topRightCorner<3, 3>() = -Skew(I.moment_O);
  dense.bottomLeftCorner<3, 3>() = Skew(I.moment_O);
  dense.bottomRightCorner<3, 3>() = I.inertia_O;
  return dense;
}

/// A joint of the open tree, in which mimic joints move independently.
struct OpenJoint {
  std::size_t parent = 0;
  Vector6 S = Vector6::Zero(), drift = Vector6::Zero();  ///< motion at unit rate; acceleration for constant rate
  Vector6 U = Vector6::Zero();                           ///< articulated inertia times S
  double inverse = 0.0;                                  ///< inverse of S^T U
  double force = 0.0;                                    ///< force available for its own acceleration
};

}  // namespace

struct ForwardDynamics::Impl {
  explicit Impl(const RobotModel& of)
      : model(of), scratch(of), joints(of.joints.size()), velocity(of.bodies.size()), inertia(of.bodies.size()) {
    own_force.assign(of.bodies.size(), Vector6::Zero());
    load = own_force;
    accelerations = own_force;
    for (std::size_t j = 0; j < joints.size(); ++j) {
      joints[j].parent = static_cast<std::size_t>(of.joints[j].parent_body);
      if (of.joints[j].is_mimic) followers.push_back(j);
    }
    const auto n = static_cast<Eigen::Index>(joints.size()), k = static_cast<Eigen::Index>(followers.size());
    open = change = pulled = given = VectorX::Zero(n);
    gears = MatrixX::Zero(k, k);
    misfit = VectorX::Zero(k);
  }

  /// Kinematics and the force for each body alone, with gravity as an upward acceleration of the world.
  void Place(const VectorX& q, const VectorX& v) {
    ForwardKinematics(model, q, scratch);
    velocity[0] = {Vector3::Zero(), v.segment<3>(3)};
    for (std::size_t j = 0; j < joints.size(); ++j) {
      const Joint& joint = model.joints[j];
      const Motion S = spatial::JointMotion(joint, scratch, j);
      const double rate = joint.multiplier * v[6 + joint.dof];
      joints[j].S = Stacked(S);
      joints[j].drift = rate * Stacked(Cross(velocity[joints[j].parent], S));
      velocity[j + 1] = velocity[joints[j].parent] + rate * S;
    }
    for (std::size_t i = 0; i < inertia.size(); ++i) {
      const spatial::Inertia I =
          spatial::InertiaOf(model.bodies[i], scratch.R_WB[i], scratch.p_WB[i] - scratch.p_WB[0]);
      inertia[i] = DenseInertia(I);
      own_force[i] = Stacked(Cross(velocity[i], I * velocity[i]));
    }
  }

  /// Articulated inertias, from the leaves to the base.
  void Factor(const VectorX& rotor_inertia) {
    for (std::size_t j = joints.size(); j-- > 0;) {
      OpenJoint& joint = joints[j];
      joint.U.noalias() = inertia[j + 1] * joint.S;
      const Joint& of = model.joints[j];
      const double rotor = rotor_inertia.size() > 0 && !of.is_mimic ? rotor_inertia[of.dof] : 0.0;
      const double moved = joint.S.dot(joint.U) + rotor;
      if (!(moved > 0.0))
        throw InvalidArgument(
            fmt::format("joint '{}' moves no body with inertia, so its acceleration is undefined", of.name));
      joint.inverse = 1.0 / moved;
      inertia[j + 1].noalias() -= joint.inverse * joint.U * joint.U.transpose();
      inertia[joint.parent] += inertia[j + 1];
    }
    base.compute(inertia[0]);
  }

  /// Accelerations of the open tree by joint into `result`, and of the base.
  /// @param moves  whether to include velocities and gravity.
  void Solve(const VectorX& torques, const Vector6& base_wrench, bool moves, VectorX& result) {
    for (std::size_t i = 0; i < load.size(); ++i) {
      if (moves) {
        load[i] = own_force[i];
      } else {
        load[i].setZero();
      }
    }
    for (std::size_t j = joints.size(); j-- > 0;) {
      OpenJoint& joint = joints[j];
      joint.force = torques[static_cast<Eigen::Index>(j)] - joint.S.dot(load[j + 1]);
      Vector6& at_parent = load[joint.parent];
      at_parent += load[j + 1] + (joint.inverse * joint.force) * joint.U;
      if (moves) at_parent.noalias() += inertia[j + 1] * joint.drift;
    }
    accelerations[0] = base.solve(base_wrench - load[0]);
    for (std::size_t j = 0; j < joints.size(); ++j) {
      const OpenJoint& joint = joints[j];
      Vector6& a = accelerations[j + 1];
      a = accelerations[joint.parent];
      if (moves) a += joint.drift;
      const double own = joint.inverse * (joint.force - joint.U.dot(a));
      a += own * joint.S;
      result[static_cast<Eigen::Index>(j)] = own;
    }
  }

  std::size_t LeaderOf(std::size_t follower) const {
    return static_cast<std::size_t>(model.dof_joint[static_cast<std::size_t>(model.joints[follower].dof)]);
  }

  /// Acceleration of a follower minus the value required by its leader. @param by_joint  accelerations by joint.
  double MisfitOf(std::size_t follower, const VectorX& by_joint) const {
    return by_joint[static_cast<Eigen::Index>(follower)] -
           model.joints[follower].multiplier * by_joint[static_cast<Eigen::Index>(LeaderOf(follower))];
  }

  /// Adds the torques of a constraint force between a follower and its leader.
  void Pull(std::size_t follower, double force, VectorX& torques) const {
    torques[static_cast<Eigen::Index>(follower)] += force;
    torques[static_cast<Eigen::Index>(LeaderOf(follower))] -= model.joints[follower].multiplier * force;
  }

  /// Adds the constraint torques that couple followers to their leaders, from the open tree's accelerations `given`.
  void Gear(VectorX& torques) {
    for (std::size_t c = 0; c < followers.size(); ++c) {
      pulled.setZero();
      Pull(followers[c], 1.0, pulled);
      Solve(pulled, Vector6::Zero(), false, change);
      for (std::size_t r = 0; r < followers.size(); ++r)
        gears(static_cast<Eigen::Index>(r), static_cast<Eigen::Index>(c)) = MisfitOf(followers[r], change);
      misfit[static_cast<Eigen::Index>(c)] = -MisfitOf(followers[c], given);
    }
    gear_factor.compute(gears);
    misfit = gear_factor.solve(misfit);
    for (std::size_t c = 0; c < followers.size(); ++c)
      Pull(followers[c], misfit[static_cast<Eigen::Index>(c)], torques);
  }

  const RobotModel& model;
  DynamicsScratch scratch;
  std::vector<OpenJoint> joints;
  std::vector<std::size_t> followers;  ///< mimic joints
  std::vector<Motion> velocity;        ///< by body
  std::vector<Matrix6> inertia;        ///< by body: articulated inertia; for a joint's child, as seen by the parent
  std::vector<Vector6> own_force, load, accelerations;  ///< by body
  Eigen::LDLT<Matrix6> base;
  VectorX open, change, pulled, given;  ///< by joint: torques, accelerations
  MatrixX gears;
  VectorX misfit;
  Eigen::LDLT<MatrixX> gear_factor;
};

ForwardDynamics::ForwardDynamics(const RobotModel& model) : impl_(std::make_unique<Impl>(model)) {}
ForwardDynamics::~ForwardDynamics() = default;

const DynamicsScratch& ForwardDynamics::kinematics() const { return impl_->scratch; }

void ForwardDynamics::Compute(const VectorX& q, const VectorX& v, const VectorX& tau, VectorX& a,
                              const VectorX& rotor_inertia) {
  Impl& self = *impl_;
  self.Place(q, v);
  self.Factor(rotor_inertia);
  self.open.setZero();
  for (int dof = 0; dof < self.model.num_dofs(); ++dof)
    self.open[self.model.dof_joint[static_cast<std::size_t>(dof)]] = tau[6 + dof];
  const Vector6 base_wrench = tau.head<6>();
  self.Solve(self.open, base_wrench, true, self.given);
  if (!self.followers.empty()) {
    self.Gear(self.open);
    self.Solve(self.open, base_wrench, true, self.given);
  }
  a.resize(self.model.nv());
  a.head<6>() = self.accelerations[0];
  a.z() -= kGravity;
  for (int dof = 0; dof < self.model.num_dofs(); ++dof)
    a[6 + dof] = self.given[self.model.dof_joint[static_cast<std::size_t>(dof)]];
}

}  // namespace gaitwright
