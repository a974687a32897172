// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/model/actuator.h"
#include "playback/bullet/shared_motors_internal.h"
#include "playback/bullet/world_options.h"

namespace gaitwright::bullet {

/// What a joint is like as a motor's load; disturbances come on top of what the model says.
MotorRow::Traits TraitsOf(const RobotModel& model, const WorldOptions& options, int dof);

/// The motors of a transmission, with what their rotors take.
SharedMotors::Traits TraitsOf(const Transmission& transmission, const WorldOptions& options);

/// The power stage of a motor, without what options switch off.
Drive DriveOf(const Actuator& actuator, const WorldOptions& options);

/// The most that a motor gives whose effort nothing limits; infinite for one that has a limit. Of a motor of a
/// transmission what its joints' bounds ask of it together.
double BoundOf(const RobotModel& model, const Actuator& actuator);

/// Of the limit that way. A motor that can give nothing one way is at its limit when it is asked to push that way; one
/// whose limit is not known has none to be at. @param bound  see BoundOf.
double ShareOfLimit(double torque, double wanted, const EffortRange& limits, double bound);

}  // namespace gaitwright::bullet
