// SPDX-License-Identifier: BSD-3-Clause
#include "playback/control/leg_targets.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <set>

#include "kinematics/dynamics/chain_kinematics.h"
#include "kinematics/dynamics/foot_contact.h"
#include "kinematics/model/actuator.h"
#include "kinematics/model/unknown_motor.h"
#include "kinematics/spatial/rotation.h"

namespace gaitwright {

LegTargets::LegTargets(const RobotModel& model) : model_(model), scratch_(model), whole_(6, model.nv()) {
  for (const Foot& foot : model.feet) chains_.push_back(JointsTo(model, foot.body));
  std::vector<int> users(static_cast<std::size_t>(model.num_dofs()), 0);
  for (const Leg& leg : model.legs) {
    std::set<int> dofs;
    for (const int joint : leg.joints) dofs.insert(model.joints[static_cast<std::size_t>(joint)].dof);
    dofs_.emplace_back(dofs.begin(), dofs.end());
    for (const int dof : dofs) ++users[static_cast<std::size_t>(dof)];
  }
  for (std::vector<int>& dofs : dofs_) {
    std::erase_if(dofs, [&](int dof) { return users[static_cast<std::size_t>(dof)] > 1; });
    if (dofs.size() < 3 || dofs.size() > kMost) dofs.clear();
  }
  for (int dof = 0; dof < model.num_dofs(); ++dof) {
    const double limit = model.dof_velocity_limit(dof);
    fastest_.push_back(std::isfinite(limit) ? limit : BoundsOfUnknownMotor(model, dof).speed);
  }
}

void LegTargets::UpdateJacobian(int leg, const Vector3& p_BQ) {
  const Foot& foot = model_.feet[static_cast<std::size_t>(leg)];
  const std::vector<int>& dofs = dofs_[static_cast<std::size_t>(leg)];
  PointJacobian(model_, scratch_, foot.body, p_BQ, whole_);
  jacobian_.resize(6, static_cast<Eigen::Index>(dofs.size()));
  for (std::size_t c = 0; c < dofs.size(); ++c) jacobian_.col(static_cast<Eigen::Index>(c)) = whole_.col(6 + dofs[c]);
  // Angles are weighted by the motion of a point at a tenth of the leg length. Unreachable targets yield softly.
  const double angular = foot.sole_F.empty() ? 0.0 : 0.1 * model_.leg_length_m();
  const double lacking = dofs.size() >= 6 ? angular : 0.01 * angular;
  const bool line = foot.type == FootType::kLine;  // cannot roll; another leg with fewer than six joints cannot yaw
  weight_ << 1.0, 1.0, 1.0, line ? lacking : angular, angular, line ? angular : lacking;
}

LegTargets::Joints LegTargets::LeastSquares(const Vector6& rows) const {
  constexpr double kDamping = 1e-7;  // [m^2]
  using Square = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMost, kMost>;
  const Jacobian weighted = weight_.asDiagonal() * jacobian_;
  Square normal = weighted.transpose() * weighted;
  normal.diagonal().array() += kDamping;
  return normal.llt().solve(Joints(weighted.transpose() * (weight_.asDiagonal() * rows)));
}

void LegTargets::Solve(int leg, const FootMotion& wanted, const VectorX& q_planned, VectorX& q, VectorX& v) {
  constexpr int kIterations = 4;
  constexpr double kLargest = 0.3;  // step [rad]
  constexpr double kMargin = 0.03;  // to a joint's limit [rad]
  const Foot& foot = model_.feet[static_cast<std::size_t>(leg)];
  const std::vector<int>& dofs = dofs_[static_cast<std::size_t>(leg)];
  const auto lowest = [&](int dof) { return std::min(model_.dof_lower(dof) + kMargin, q_planned[7 + dof]); };
  const auto highest = [&](int dof) { return std::max(model_.dof_upper(dof) - kMargin, q_planned[7 + dof]); };
  Vector6 error;
  for (int iteration = 0; iteration < kIterations; ++iteration) {
    ChainKinematics(model_, q, chains_[static_cast<std::size_t>(leg)], scratch_);
    UpdateJacobian(leg, foot.X_BF.translation());
    const Pose X_WF = FramePose(scratch_, foot.body, foot.X_BF);
    error << wanted.X_WF.translation() - X_WF.translation(),
        RotationLog(wanted.X_WF.linear() * X_WF.linear().transpose());
    const Joints step = LeastSquares(error);
    for (std::size_t c = 0; c < dofs.size(); ++c) {
      const int dof = dofs[c];
      const double wanted_q = q[7 + dof] + std::clamp(step[static_cast<Eigen::Index>(c)], -kLargest, kLargest);
      q[7 + dof] = std::clamp(wanted_q, lowest(dof), highest(dof));
    }
  }
  SetRates(leg, wanted.v_WF, v);
  for (const int dof : dofs) {  // no speed beyond a limit either
    if (q[7 + dof] <= lowest(dof)) v[6 + dof] = std::max(v[6 + dof], 0.0);
    if (q[7 + dof] >= highest(dof)) v[6 + dof] = std::min(v[6 + dof], 0.0);
  }
}

void LegTargets::SetRates(int leg, const Vector6& wanted, VectorX& v) const {
  const std::vector<int>& dofs = dofs_[static_cast<std::size_t>(leg)];
  for (const int dof : dofs) v[6 + dof] = 0.0;
  const Joints rate = LeastSquares(wanted - whole_ * v);
  for (std::size_t c = 0; c < dofs.size(); ++c) {
    const double fastest = fastest_[static_cast<std::size_t>(dofs[c])];
    v[6 + dofs[c]] = std::clamp(rate[static_cast<Eigen::Index>(c)], -fastest, fastest);
  }
  if (!model_.transmissions.empty()) KeepMotorSpeeds(dofs, v);
}

/// Limits the joint speeds of transmissions to those that their motors can reach.
void LegTargets::KeepMotorSpeeds(const std::vector<int>& dofs, VectorX& v) const {
  const Eigen::Index n = model_.num_dofs();
  const VectorX kept = ClampedSpeeds(model_, v.tail(n));
  for (const int dof : dofs) {
    if (model_.TransmissionOf(dof) != nullptr) v[6 + dof] = kept[dof];
  }
}

void LegTargets::Hold(int leg, const Vector3& normal_W, double creep_m_s, const VectorX& q, VectorX& v) {
  const Foot& foot = model_.feet[static_cast<std::size_t>(leg)];
  ChainKinematics(model_, q, chains_[static_cast<std::size_t>(leg)], scratch_);
  const auto body = static_cast<std::size_t>(foot.body);
  const Vector3 p_WQ = ContactFrame(model_, scratch_, leg, normal_W).translation();
  UpdateJacobian(leg, scratch_.R_WB[body].transpose() * (p_WQ - scratch_.p_WB[body]));
  const Vector6 moves = whole_ * v;
  const double speed = weight_.cwiseProduct(moves).norm();
  SetRates(leg, speed > creep_m_s ? Vector6(creep_m_s / speed * moves) : moves, v);
}

VectorX LegTargets::SettlingShares(int leg, const Vector3& normal_W) const {
  constexpr double kTurns = 0.5;  // cosine of the angle between axis and normal
  const Foot& foot = model_.feet[static_cast<std::size_t>(leg)];
  const double length = model_.legs[static_cast<std::size_t>(leg)].length_m;
  VectorX shares = VectorX::Ones(jacobian_.cols());
  double radius = 0.0;
  for (const Vector2& p_F : foot.sole_F) radius = std::max(radius, p_F.norm());
  if (radius == 0.0 || length <= 0.0) return shares;
  for (Eigen::Index c = 0; c < shares.size(); ++c) {
    const Vector3 turn = jacobian_.col(c).tail<3>();
    if (std::abs(turn.dot(normal_W)) >= kTurns * turn.norm()) continue;  // also a prismatic joint
    const double arm = jacobian_.col(c).head<3>().norm() / turn.norm();
    shares[c] = std::pow(std::min(std::max(arm, radius) / length, 1.0), 2);
  }
  return shares;
}

VectorX LegTargets::ExtraTorque(int leg, const FootMotion& wanted, const MatrixX& M) const {
  const std::vector<int>& dofs = dofs_[static_cast<std::size_t>(leg)];
  Vector6 rows = Vector6::Zero();
  rows.head<3>() = wanted.a_extra_WF;
  const Joints acceleration = LeastSquares(rows);
  VectorX torque = VectorX::Zero(static_cast<Eigen::Index>(dofs.size()));
  for (std::size_t i = 0; i < dofs.size(); ++i) {
    for (std::size_t j = 0; j < dofs.size(); ++j)
      torque[static_cast<Eigen::Index>(i)] += M(6 + dofs[i], 6 + dofs[j]) * acceleration[static_cast<Eigen::Index>(j)];
  }
  return torque;
}

}  // namespace gaitwright
