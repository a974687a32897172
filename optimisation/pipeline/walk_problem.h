// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "optimisation/pipeline/crouch.h"
#include "optimisation/pipeline/flight_swings.h"
#include "optimisation/pipeline/motion_passes.h"
#include "optimisation/pipeline/robot_body.h"

namespace gaitwright {

/// The robot as it stands, or crouches, with its feet no farther below it than legs are fast enough for.
StandingBody CarriedBody(const RobotModel& model, const Crouch* crouch);

/// A walk as a problem for a single rigid body before anything is known of how its legs move: ProblemOf with the
/// friction that a plan may use, the speed that the motors let the body rise with, and the swings.
RigidBodyProblem WalkProblem(const MotionTask& task, const StandingBody& body, const Crouch* crouch,
                             const FlightSwings& shapes);

/// The options for this problem (FittedOptions), with knots on the plan's grid.
RigidBodyOptions WalkOptions(const MotionTask& task, const RigidBodyProblem& problem);

}  // namespace gaitwright
