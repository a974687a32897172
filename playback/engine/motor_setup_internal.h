// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/model/actuator.h"
#include "playback/engine/drive_internal.h"
#include "playback/engine/world_options.h"

namespace gaitwright::engine {

/// A joint as the load of a motor.
struct JointTraits {
  double lower, upper;        ///< position
  double damping, friction;   ///< of the joints of the coordinate
  double rotor_inertia;       ///< reflected to the coordinate
  double torque_scale = 1.0;  ///< share of the motor's torque that reaches the joint

  bool drags() const { return damping > 0.0 || rotor_inertia > 0.0; }
};

/// Load that a joint is for its motor: the losses of the model plus the disturbances of the options.
JointTraits TraitsOf(const RobotModel& model, const WorldOptions& options, int dof);

/// The power stage of a motor, without the limits that options switch off.
Drive DriveOf(const Actuator& actuator, const WorldOptions& options);

/// Largest effort of a motor without an effort limit; infinite for a motor with a limit. For a motor of a transmission,
/// it is the sum of the bounds of its joints.
double BoundOf(const RobotModel& model, const Actuator& actuator);

/// Share of the limit in the direction of the torque. If the limit in the requested direction is zero, the motor is at
/// its limit (1). If the limit is unknown, the share is 0. @param bound  see BoundOf.
double ShareOfLimit(double torque, double wanted, const EffortRange& limits, double bound);

}  // namespace gaitwright::engine
