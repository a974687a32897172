// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "optimisation/pipeline/crouch.h"
#include "optimisation/pipeline/flight_swings.h"
#include "optimisation/pipeline/motion_passes.h"
#include "optimisation/pipeline/robot_body.h"

namespace gaitwright {

/// The robot's body in standing or crouching. The feet are no farther below it than the legs' speeds allow.
StandingBody CarriedBody(const RobotModel& model, const Crouch* crouch);

/// A walk as a problem for a single rigid body before the motion of its legs is known: ProblemOf with the friction that
/// a plan may use, the largest rising speed of the motors, and the swings.
RigidBodyProblem WalkProblem(const MotionTask& task, const StandingBody& body, const Crouch* crouch,
                             const FlightSwings& shapes);

/// Options for this problem (FittedOptions), with nodes on the plan's grid.
RigidBodyOptions WalkOptions(const MotionTask& task, const RigidBodyProblem& problem);

}  // namespace gaitwright
