// SPDX-License-Identifier: BSD-3-Clause
#include "planning/audit/motor_effort.h"

#include <algorithm>
#include <cmath>

namespace gaitwright {

MotorEffort::MotorEffort(const RobotModel& model)
    : own_(static_cast<std::size_t>(model.num_dofs())), motors_(ActuatorsOf(model)) {
  for (int d = 0; d < model.num_dofs(); ++d) own_[static_cast<std::size_t>(d)].inertia = model.MotorOf(d).rotor_inertia;
  for (const Joint& joint : model.joints) {
    Own& own = own_[static_cast<std::size_t>(joint.dof)];
    own.damping += joint.multiplier * joint.multiplier * joint.damping;
    own.friction += std::abs(joint.multiplier) * joint.friction;
  }
}

double MotorEffort::AtJoint(int dof, double tau, double v, double a) const {
  constexpr double kAtRest = 0.01;  // [rad/s] or [m/s]
  const Own& own = own_[static_cast<std::size_t>(dof)];
  return tau + own.damping * v + own.friction * std::clamp(v / kAtRest, -1.0, 1.0) + own.inertia * a;
}

double MotorEffort::Of(int motor, const Eigen::Ref<const VectorX>& tau, const Eigen::Ref<const VectorX>& v,
                       const Eigen::Ref<const VectorX>& a) const {
  const Actuator& of = motors_[static_cast<std::size_t>(motor)];
  if (!of.shared()) return AtJoint(motor, tau[motor], v[motor], a[motor]);
  double effort = of.motor.rotor_inertia * of.Speed(a);
  for (const Actuator::Term& term : of.terms)
    effort += term.by_effort * AtJoint(term.dof, tau[term.dof], v[term.dof], a[term.dof]);
  return effort;
}

}  // namespace gaitwright
