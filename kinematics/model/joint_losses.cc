// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/joint_losses.h"

#include <algorithm>
#include <cmath>

namespace gaitwright {

JointLosses LossesOf(const RobotModel& model, int dof) {
  JointLosses losses{.rotor_inertia = model.MotorOf(dof).rotor_inertia};
  for (const Joint& joint : model.joints) {
    if (joint.dof != dof) continue;
    losses.damping += joint.multiplier * joint.multiplier * joint.damping;
    losses.friction += std::abs(joint.multiplier) * joint.friction;
  }
  return losses;
}

RobotModel WithoutLosses(const RobotModel& model) {
  RobotModel lossless = model;
  for (Joint& joint : lossless.joints) joint.damping = joint.friction = 0.0;
  for (Motor& motor : lossless.motors) motor.rotor_inertia = 0.0;
  for (Transmission& t : lossless.transmissions) {
    for (TransmissionMotor& motor : t.motors) motor.motor.rotor_inertia = 0.0;
  }
  return lossless;
}

void AddRotorInertia(const RobotModel& model, MatrixX& M) {
  for (int dof = 0; dof < model.num_dofs(); ++dof) M(6 + dof, 6 + dof) += model.MotorOf(dof).rotor_inertia;
  for (const Transmission& t : model.transmissions) {
    const MatrixX inertia = t.RotorInertia();
    for (Eigen::Index i = 0; i < t.size(); ++i) {
      for (Eigen::Index j = 0; j < t.size(); ++j)
        M(6 + t.dofs[static_cast<std::size_t>(i)], 6 + t.dofs[static_cast<std::size_t>(j)]) += inertia(i, j);
    }
  }
}

double RotorInertiaAt(const RobotModel& model, int dof) {
  double inertia = model.MotorOf(dof).rotor_inertia;
  if (const Transmission* t = model.TransmissionOf(dof)) {
    const auto place = std::find(t->dofs.begin(), t->dofs.end(), dof) - t->dofs.begin();
    inertia += t->RotorInertia()(place, place);
  }
  return inertia;
}

}  // namespace gaitwright
