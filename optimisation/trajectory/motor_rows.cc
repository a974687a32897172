// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "kinematics/model/joint_losses.h"
#include "optimisation/trajectory/motor_rows_internal.h"

namespace gaitwright {

MotorRows::MotorRows(const RobotModel& model, const BodyLimitUse& use) : motors_(ActuatorsOf(model)) {
  constexpr double kUnlimited = 0.1;   // of the weight times the leg's length: scale of motors without a limit
  constexpr double kLeastShare = 0.1;  // of a limit that dry friction leaves
  constexpr double kSticks = 0.5;      // of a limit
  std::vector<double> friction;
  sticks_.assign(static_cast<std::size_t>(model.num_dofs()), false);
  for (int d = 0; d < model.num_dofs(); ++d) {
    const JointLosses losses = LossesOf(model, d);
    damping_.push_back(losses.damping);
    friction.push_back(losses.friction);
  }
  for (int m = 0; m < count(); ++m) {
    const Actuator& motor = motors_[static_cast<std::size_t>(m)];
    double lost = 0.0;
    for (const Actuator::Term& term : motor.terms)
      lost += std::abs(term.by_effort) * friction[static_cast<std::size_t>(term.dof)];
    const double limit = motor.effort_limit;
    const bool known = std::isfinite(limit);
    if (known && !motor.shared() && lost >= kSticks * limit) {
      sticks_[static_cast<std::size_t>(motor.terms.front().dof)] = true;
      lost = 0.0;
    }
    const auto factor = [&](const std::vector<double>& of) {
      return of.empty() ? 1.0 : of[static_cast<std::size_t>(m)];
    };
    const double most = known ? std::max(factor(use.effort_of) * use.effort * limit - lost, kLeastShare * limit)
                              : kUnlimited * model.weight_n() * (motor.slides ? 1.0 : model.leg_length_m());
    scale_.push_back(most);
    rotor_.push_back(motor.motor.rotor_inertia);
    if (known) limited_.push_back(m);
    if (std::isfinite(motor.velocity_limit))
      curves_.push_back({m, 0.0, factor(use.speed_of) * use.speed * motor.velocity_limit});
    if (known && motor.motor.has_curve()) {
      const double no_load = motor.motor.no_load_speed;
      curves_.push_back({m, (no_load - motor.motor.corner_speed) / no_load, factor(use.speed_of) * no_load});
    }
  }
}

void MotorRows::Efforts(const Eigen::Ref<const VectorX>& torque, const Eigen::Ref<const VectorX>& v,
                        const Eigen::Ref<const VectorX>& a, Eigen::Ref<VectorX> shares) const {
  for (std::size_t m = 0; m < motors_.size(); ++m) {
    const Actuator& motor = motors_[m];
    double effort = rotor_[m] * motor.Speed(a);
    for (const Actuator::Term& term : motor.terms)
      effort += term.by_effort * (torque[term.dof] + damping_[static_cast<std::size_t>(term.dof)] * v[term.dof]);
    shares[static_cast<Eigen::Index>(m)] = effort / scale_[m];
  }
}

void MotorRows::Raise(const Eigen::Ref<const VectorX>& torque, const Eigen::Ref<const VectorX>& v,
                      const Eigen::Ref<const VectorX>& a, Largest& largest) const {
  if (largest.effort.size() == 0) largest.effort = largest.curve = VectorX::Zero(count());
  VectorX shares(count());
  Efforts(torque, v, a, shares);
  for (const int motor : limited_) largest.effort[motor] = std::max(largest.effort[motor], std::abs(shares[motor]));
  for (const Curve& curve : curves_) {
    const double speed = motors_[static_cast<std::size_t>(curve.motor)].Speed(v) / curve.speed_scale;
    double& most = largest.curve[curve.motor];
    most = std::max(most, std::abs(curve.by_effort * shares[curve.motor] + speed));
  }
}

void MotorRows::ToMotors(const Eigen::Ref<const MatrixX>& of_torque, Eigen::Ref<MatrixX> of_shares) const {
  for (std::size_t m = 0; m < motors_.size(); ++m) {
    auto row = of_shares.row(static_cast<Eigen::Index>(m));
    row.setZero();
    for (const Actuator::Term& term : motors_[m].terms) row += term.by_effort / scale_[m] * of_torque.row(term.dof);
  }
}

void MotorRows::AddLosses(Eigen::Ref<MatrixX> by_v, Eigen::Ref<MatrixX> by_a) const {
  for (std::size_t m = 0; m < motors_.size(); ++m) {
    const auto row = static_cast<Eigen::Index>(m);
    for (const Actuator::Term& term : motors_[m].terms) {
      by_v(row, term.dof) += term.by_effort * damping_[static_cast<std::size_t>(term.dof)] / scale_[m];
      by_a(row, term.dof) += rotor_[m] * term.by_speed / scale_[m];
    }
  }
}

}  // namespace gaitwright
