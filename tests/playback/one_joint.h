// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>

#include "kinematics/model/robot_model.h"

namespace gaitwright::one_joint {

/// Two floating bodies, connected by one joint through both centres of mass. Without other forces the joint moves as
/// one body of the reduced mass or inertia, kInertia, and gravity has no effect on it.
inline constexpr double kInertia = 0.8, kEffort = 10.0;

/// A prismatic joint along x between 4 kg and 1 kg, or a hinge about z between 4 kg m^2 and 1 kg m^2; no feet, no
/// limits.
inline RobotModel Make(JointType type) {
  RobotModel model;
  model.name = "one_joint";
  const double no_limit = std::numeric_limits<double>::infinity();
  model.bodies.push_back({.name = "heavy", .mass = 4.0, .I_C = 4.0 * Matrix3::Identity()});
  model.bodies.push_back({.name = "light", .mass = 1.0, .I_C = Matrix3::Identity()});
  model.joints.push_back({.name = "joint",
                          .type = type,
                          .axis_J = type == JointType::kPrismatic ? Vector3::UnitX() : Vector3::UnitZ(),
                          .lower = -no_limit,
                          .upper = no_limit,
                          .velocity_limit = 100.0,
                          .effort_limit = kEffort});
  model.total_mass_kg = 5.0;
  model.dof_names = {"joint"};
  model.dof_joint = {0};
  model.standing_joints = model.stiffness = model.damping = VectorX::Zero(1);
  model.motors.resize(1);
  return model;
}

}  // namespace gaitwright::one_joint
