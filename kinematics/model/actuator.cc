// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/actuator.h"

#include <algorithm>
#include <cmath>

namespace gaitwright {
namespace {

template <class Figure>
double SumOfTerms(const std::vector<Actuator::Term>& terms, Figure figure) {
  double sum = figure(terms.front());
  for (std::size_t i = 1; i < terms.size(); ++i) sum += figure(terms[i]);
  return sum;
}

void CountUse(int motor, double size, double limit, LargestUse& largest) {
  if (!std::isfinite(limit)) return;
  const double share = size > 0.0 ? size / limit : 0.0;
  if (largest.motor >= 0 && share <= largest.share) return;
  largest = {motor, share};
}

/// The limits of efforts or of speeds, with the maps of a transmission from joints to motors and back.
struct MotorBounds {
  double (RobotModel::*joint_limit)(int dof) const;
  double TransmissionMotor::*motor_limit;
  MatrixX (*to_motors)(const Transmission&);
  MatrixX (*to_joints)(const Transmission&);
};

VectorX ClampedAtMotors(const RobotModel& model, const VectorX& of_joints, const MotorBounds& bounds) {
  VectorX clamped = of_joints;
  for (int dof = 0; dof < model.num_dofs(); ++dof) {
    if (model.TransmissionOf(dof) != nullptr) continue;
    const double limit = (model.*bounds.joint_limit)(dof);
    clamped[dof] = std::clamp(of_joints[dof], -limit, limit);
  }
  for (const Transmission& t : model.transmissions) {
    VectorX of_motors = bounds.to_motors(t) * t.Own(of_joints);
    for (Eigen::Index m = 0; m < t.size(); ++m) {
      const double limit = t.motors[static_cast<std::size_t>(m)].*bounds.motor_limit;
      of_motors[m] = std::clamp(of_motors[m], -limit, limit);
    }
    t.Put(bounds.to_joints(t) * of_motors, clamped);
  }
  return clamped;
}

}  // namespace

double Actuator::Speed(const Eigen::Ref<const VectorX>& v) const {
  return SumOfTerms(terms, [&](const Term& term) { return term.by_speed * v[term.dof]; });
}

double Actuator::Effort(const Eigen::Ref<const VectorX>& tau) const {
  return SumOfTerms(terms, [&](const Term& term) { return term.by_effort * tau[term.dof]; });
}

Actuator ActuatorOf(const RobotModel& model, int index) {
  Actuator actuator;
  const Transmission* t = model.TransmissionOf(index);
  if (t == nullptr) {
    actuator.name = model.dof_names[static_cast<std::size_t>(index)];
    actuator.terms = {{index, 1.0, 1.0}};
    actuator.effort_limit = model.dof_effort_limit(index);
    actuator.velocity_limit = model.dof_velocity_limit(index);
    actuator.slides = model.LeaderOf(index).is_prismatic();
    actuator.motor = model.MotorOf(index);
    return actuator;
  }
  const auto place = std::find(t->dofs.begin(), t->dofs.end(), index) - t->dofs.begin();
  const TransmissionMotor& motor = t->motors[static_cast<std::size_t>(place)];
  for (Eigen::Index i = 0; i < t->size(); ++i)
    actuator.terms.push_back({t->dofs[static_cast<std::size_t>(i)], t->ratios(place, i), t->inverse(i, place)});
  actuator.name = motor.name;
  actuator.effort_limit = motor.effort_limit;
  actuator.velocity_limit = motor.velocity_limit;
  actuator.slides = motor.slides;
  actuator.motor = motor.motor;
  actuator.transmission = static_cast<int>(t - model.transmissions.data());
  return actuator;
}

std::vector<Actuator> ActuatorsOf(const RobotModel& model) {
  std::vector<Actuator> actuators;
  for (int index = 0; index < model.num_dofs(); ++index) actuators.push_back(ActuatorOf(model, index));
  return actuators;
}

LargestUse LargestEffortUse(const RobotModel& model, const VectorX& tau) {
  LargestUse largest;
  for (int index = 0; index < model.num_dofs(); ++index) {
    const Actuator actuator = ActuatorOf(model, index);
    CountUse(index, std::abs(actuator.Effort(tau)), actuator.effort_limit, largest);
  }
  return largest;
}

LargestUse LargestSpeedUse(const RobotModel& model, const VectorX& v) {
  LargestUse largest;
  for (int index = 0; index < model.num_dofs(); ++index) {
    const Actuator actuator = ActuatorOf(model, index);
    CountUse(index, std::abs(actuator.Speed(v)), actuator.velocity_limit, largest);
  }
  return largest;
}

VectorX ClampedEfforts(const RobotModel& model, const VectorX& tau) {
  return ClampedAtMotors(model, tau,
                         {.joint_limit = &RobotModel::dof_effort_limit,
                          .motor_limit = &TransmissionMotor::effort_limit,
                          .to_motors = [](const Transmission& t) -> MatrixX { return t.inverse.transpose(); },
                          .to_joints = [](const Transmission& t) -> MatrixX { return t.ratios.transpose(); }});
}

VectorX ClampedSpeeds(const RobotModel& model, const VectorX& v) {
  return ClampedAtMotors(model, v,
                         {.joint_limit = &RobotModel::dof_velocity_limit,
                          .motor_limit = &TransmissionMotor::velocity_limit,
                          .to_motors = [](const Transmission& t) -> MatrixX { return t.ratios; },
                          .to_joints = [](const Transmission& t) -> MatrixX { return t.inverse; }});
}

}  // namespace gaitwright
