// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Cholesky>

#include "kinematics/dynamics/chain_kinematics.h"
#include "kinematics/spatial/rotation.h"
#include "optimisation/trajectory/knot_model_internal.h"

namespace gaitwright {
namespace {

/// A foot's contact as one wrench about P, the foot's origin moved by the contact's offset.
struct FootWrench {
  Vector3 P_W = Vector3::Zero(), force_W = Vector3::Zero(), moment_W = Vector3::Zero();
  Matrix3 moment_by_turn = Matrix3::Zero();  ///< change of the moment when the foot turns by a small vector
};

FootWrench WrenchOf(const KnotContact& contact, const Pose& X_WF, const Eigen::Ref<const VectorX>& forces_W) {
  FootWrench wrench;
  wrench.P_W = X_WF.translation() + contact.offset_W;
  for (std::size_t i = 0; i < contact.points_F.size(); ++i) {
    const Vector3 arm = X_WF.linear() * contact.points_F[i], f = forces_W.segment<3>(static_cast<Eigen::Index>(3 * i));
    wrench.force_W += f;
    wrench.moment_W += arm.cross(f);
    wrench.moment_by_turn += Skew(f) * Skew(arm);
  }
  return wrench;
}

}  // namespace

KnotModel::KnotModel(const RobotModel& model)
    : model_(model), scratch_(model), derivatives_(model), foot_J_(6, model.nv()) {
  for (const Foot& foot : model.feet) chain_.push_back(JointsTo(model, foot.body));
}

void KnotModel::Evaluate(const VectorX& q, const VectorX& v, const VectorX& a, const std::vector<KnotContact>& contacts,
                         const Eigen::Ref<const VectorX>& forces_W, VectorX& needed) {
  InverseDynamics(model_, q, v, a, scratch_, needed);
  differentiated_ = false;
  Eigen::Index at = 0;
  for (const KnotContact& contact : contacts) {
    const auto size = static_cast<Eigen::Index>(3 * contact.points_F.size());
    AddContact(contact, forces_W.segment(at, size), needed);
    at += size;
  }
}

void KnotModel::AddContact(const KnotContact& contact, const Eigen::Ref<const VectorX>& forces_W,
                           VectorX& needed) const {
  const DynamicsScratch& s = kinematics();
  const Foot& foot = model_.feet[static_cast<std::size_t>(contact.foot)];
  const FootWrench w = WrenchOf(contact, FramePose(s, foot.body, foot.X_BF), forces_W);
  needed.head<3>() -= w.force_W;
  needed.segment<3>(3) -= (w.P_W - s.p_WB[0]).cross(w.force_W) + w.moment_W;
  for (const int joint : ChainOf(contact.foot)) {
    const auto j = static_cast<std::size_t>(joint);
    const Joint& of = model_.joints[j];
    const Vector3 turned = (w.P_W - s.p_WB[j + 1]).cross(w.force_W) + w.moment_W;
    needed[6 + of.dof] -= of.multiplier * s.axis_W[j].dot(of.is_prismatic() ? w.force_W : turned);
  }
}

void KnotModel::Differentiate(const VectorX& q, const VectorX& v, const VectorX& a,
                              const std::vector<KnotContact>& contacts, const Eigen::Ref<const VectorX>& forces_W,
                              KnotForces& result) {
  derivatives_.Compute(q, v, a, of_bodies_);
  differentiated_ = true;
  result.needed = of_bodies_.tau;
  result.by_q.swap(of_bodies_.by_q);
  result.by_v.swap(of_bodies_.by_v);
  result.by_a.swap(of_bodies_.M);
  result.by_force.setZero(model_.nv(), forces_W.size());
  Eigen::Index at = 0;
  for (const KnotContact& contact : contacts) {
    const auto size = static_cast<Eigen::Index>(3 * contact.points_F.size());
    AddContact(contact, forces_W.segment(at, size), result.needed);
    AddContactDerivatives(contact, forces_W.segment(at, size), at, result);
    at += size;
  }
}

void KnotModel::AddContactDerivatives(const KnotContact& contact, const Eigen::Ref<const VectorX>& forces_W,
                                      Eigen::Index column, KnotForces& result) {
  const DynamicsScratch& s = derivatives_.kinematics();
  const Foot& foot = model_.feet[static_cast<std::size_t>(contact.foot)];
  const Pose X_WF = FramePose(s, foot.body, foot.X_BF);
  const FootWrench w = WrenchOf(contact, X_WF, forces_W);
  const Vector3& F = w.force_W;
  const std::vector<int>& chain = ChainOf(contact.foot);

  // A motion that moves P by `moves` and turns the foot by `turns`, and of what is before joint j its axis by
  // `turns_j` and its origin by `moves_j`, changes a_j . ((P - o_j) x F + M).
  const auto axis_of = [&](std::size_t j) -> const Vector3& { return s.axis_W[j]; };
  const auto add_column = [&](Eigen::Index to, double scale, const Vector3& about, const Vector3& turns,
                              const Vector3& slides, std::size_t first) {
    const auto moved = [&](const Vector3& p) -> Vector3 { return slides + turns.cross(p - about); };
    const Vector3 P_moves = moved(X_WF.translation()), M_changes = w.moment_by_turn * turns;
    result.by_q.col(to).segment<3>(3) -= scale * (P_moves.cross(F) + M_changes);
    for (std::size_t i = 0; i < chain.size(); ++i) {
      const auto j = static_cast<std::size_t>(chain[i]);
      const Joint& of = model_.joints[j];
      const bool carried = i >= first;  // by the motion
      const Vector3 axis_changes = carried ? turns.cross(axis_of(j)) : Vector3::Zero().eval();
      double change = axis_changes.dot(F);
      if (!of.is_prismatic()) {
        const Vector3 arm = w.P_W - s.p_WB[j + 1];
        const Vector3 arm_moves = carried ? P_moves - moved(s.p_WB[j + 1]) : P_moves;
        change = axis_changes.dot(arm.cross(F) + w.moment_W) + axis_of(j).dot(arm_moves.cross(F) + M_changes);
      }
      result.by_q(6 + of.dof, to) -= scale * of.multiplier * change;
    }
  };
  for (int k = 0; k < 3; ++k) add_column(3 + k, 1.0, s.p_WB[0], Vector3::Unit(k), Vector3::Zero(), 0);
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const auto j = static_cast<std::size_t>(chain[i]);
    const Joint& of = model_.joints[j];
    const bool slides = of.is_prismatic();
    const Vector3 none = Vector3::Zero();
    add_column(6 + of.dof, of.multiplier, s.p_WB[j + 1], slides ? none : axis_of(j), slides ? axis_of(j) : none, i + 1);
  }
  for (std::size_t p = 0; p < contact.points_F.size(); ++p) {
    const Vector3 at = w.P_W + X_WF.linear() * contact.points_F[p];
    auto columns = result.by_force.middleCols<3>(column + static_cast<Eigen::Index>(3 * p));
    columns.topRows<3>() -= Matrix3::Identity();
    columns.middleRows<3>(3) -= Skew(at - s.p_WB[0]);
    for (const int joint : chain) {
      const auto j = static_cast<std::size_t>(joint);
      const Joint& of = model_.joints[j];
      const Vector3 lever = of.is_prismatic() ? axis_of(j) : Vector3(axis_of(j).cross(at - s.p_WB[j + 1]));
      columns.row(6 + of.dof) -= of.multiplier * lever.transpose();
    }
  }
}

void KnotModel::FootAt(int foot, bool with_jacobian, KnotFoot& result) const {
  const DynamicsScratch& s = kinematics();
  const Foot& of = model_.feet[static_cast<std::size_t>(foot)];
  const Pose X_WF = FramePose(s, of.body, of.X_BF);
  result.p_WF = X_WF.translation();
  result.R_WF = X_WF.linear();
  if (!with_jacobian) return;
  result.J.resize(6, model_.nv());
  PointJacobian(model_, s, of.body, of.X_BF.translation(), result.J);
}

Vector6 KnotModel::LockedAcceleration(const Vector6& wrench_W) const {
  const DynamicsScratch& s = kinematics();
  const Vector3 arm = CentreOfMass(model_, s) - s.p_WB[0], force = wrench_W.head<3>();
  Vector6 acceleration;
  acceleration.tail<3>() = LockedInertia(model_, s).llt().solve(wrench_W.tail<3>() - arm.cross(force));
  acceleration.head<3>() = force / model_.total_mass_kg - acceleration.tail<3>().cross(arm);
  return acceleration;
}

Vector6 KnotModel::LockedWrench(const Vector6& acceleration_W) const {
  const DynamicsScratch& s = kinematics();
  const Vector3 arm = CentreOfMass(model_, s) - s.p_WB[0], turning = acceleration_W.tail<3>();
  Vector6 wrench;
  wrench.head<3>() = model_.total_mass_kg * (acceleration_W.head<3>() + turning.cross(arm));
  wrench.tail<3>() = LockedInertia(model_, s) * turning + arm.cross(wrench.head<3>());
  return wrench;
}

}  // namespace gaitwright
