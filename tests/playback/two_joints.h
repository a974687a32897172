// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>

#include "kinematics/model/robot_model.h"

namespace gaitwright::two_joints {

inline constexpr double kEffort = 10.0;

/// A heavy floating base, with two hinges about z at its centre that carry 1 and 2 kg m^2: a torque on one hinge hardly
/// moves the other. No feet, no limits except effort limits.
inline RobotModel Make() {
  RobotModel model;
  model.name = "two_joints";
  const double no_limit = std::numeric_limits<double>::infinity();
  for (const double size : {1e9, 1.0, 2.0})
    model.bodies.push_back({.name = "body", .mass = size, .I_C = size * Matrix3::Identity()});
  for (const int dof : {0, 1}) {
    model.dof_names.push_back(dof == 0 ? "first" : "second");
    model.joints.push_back({.name = model.dof_names.back(),
                            .axis_J = Vector3::UnitZ(),
                            .lower = -no_limit,
                            .upper = no_limit,
                            .velocity_limit = 100.0,
                            .effort_limit = kEffort,
                            .dof = dof});
  }
  model.total_mass_kg = 1e9 + 3.0;
  model.dof_joint = {0, 1};
  model.standing_joints = model.stiffness = model.damping = VectorX::Zero(2);
  model.motors.resize(2);
  return model;
}

/// With both hinges driven by shared motors of kEffort.
inline RobotModel Driven(const MatrixX& ratios, double effort = kEffort, double rotor = 0.0) {
  RobotModel model = Make();
  Transmission t{"t", {0, 1}, {}, ratios, {}};
  for (const char* name : {"a", "b"}) {
    TransmissionMotor motor{.name = name, .effort_limit = effort, .velocity_limit = 100.0};
    motor.motor.rotor_inertia = rotor;
    t.motors.push_back(motor);
  }
  AddTransmission(t, model);
  return model;
}

}  // namespace gaitwright::two_joints
