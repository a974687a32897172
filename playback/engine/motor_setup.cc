// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "kinematics/model/joint_losses.h"
#include "kinematics/model/unknown_motor.h"
#include "playback/engine/motor_setup_internal.h"

namespace gaitwright::engine {

JointTraits TraitsOf(const RobotModel& model, const WorldOptions& options, int dof) {
  JointTraits traits{
      .lower = model.dof_lower(dof),
      .upper = model.dof_upper(dof),
      .damping = 0.0,
      .friction = options.joint_friction_nm,
      .rotor_inertia = model.TransmissionOf(dof) == nullptr ? options.rotor_inertia_kg_m2 : 0.0,
      .torque_scale = options.torque_scale,
  };
  if (!options.joint_losses) return traits;
  const JointLosses losses = LossesOf(model, dof);
  traits.damping += losses.damping;
  traits.friction += losses.friction;
  traits.rotor_inertia += losses.rotor_inertia;
  return traits;
}

Drive DriveOf(const Actuator& actuator, const WorldOptions& options) {
  Motor motor = actuator.motor;
  if (!options.motor_curve) motor.corner_speed = motor.no_load_speed = Motor::kNone;
  if (!options.thermal_limit) motor.continuous_effort = Motor::kNone;
  return {motor, options.motor_strength * actuator.effort_limit};
}

double BoundOf(const RobotModel& model, const Actuator& actuator) {
  if (std::isfinite(actuator.effort_limit)) return Motor::kNone;
  double bound = 0.0;
  for (const Actuator::Term& term : actuator.terms)
    if (term.by_effort != 0.0) bound += std::abs(term.by_effort) * BoundsOfUnknownMotor(model, term.dof).effort;
  return bound;
}

double ShareOfLimit(double torque, double wanted, const EffortRange& limits, double bound) {
  const double direction = torque != 0.0 ? torque : wanted;
  if (direction == 0.0) return 0.0;
  const double limit = direction > 0.0 ? limits.highest : -limits.lowest;
  if (limit >= bound) return 0.0;
  return std::abs(torque) >= limit * (1.0 - 1e-9) ? 1.0 : std::abs(torque) / limit;
}

}  // namespace gaitwright::engine
