// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/model/actuator.h"
#include "playback/engine/drive_internal.h"
#include "playback/engine/world_options.h"

namespace gaitwright::engine {

/// A joint as the load of a motor.
struct JointTraits {
  double lower, upper;        ///< position
  double damping, friction;   ///< of its joints
  double rotor_inertia;       ///< as felt at the coordinate
  double torque_scale = 1.0;  ///< share of the motor's torque that arrives

  bool drags() const { return damping > 0.0 || rotor_inertia > 0.0; }
};

/// What a joint is like as a motor's load; disturbances come on top of what the model says.
JointTraits TraitsOf(const RobotModel& model, const WorldOptions& options, int dof);

/// The power stage of a motor, without what options switch off.
Drive DriveOf(const Actuator& actuator, const WorldOptions& options);

/// The most that a motor gives whose effort nothing limits; infinite for one that has a limit. Of a motor of a
/// transmission what its joints' bounds ask of it together.
double BoundOf(const RobotModel& model, const Actuator& actuator);

/// Of the limit that way. A motor that can give nothing one way is at its limit when it is asked to push that way; one
/// whose limit is not known has none to be at. @param bound  see BoundOf.
double ShareOfLimit(double torque, double wanted, const EffortRange& limits, double bound);

}  // namespace gaitwright::engine
