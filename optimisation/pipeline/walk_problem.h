// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "optimisation/centroidal/patch_choices.h"
#include "optimisation/pipeline/crouch.h"
#include "optimisation/pipeline/flight_swings.h"
#include "optimisation/pipeline/motion_passes.h"
#include "optimisation/pipeline/robot_body.h"

namespace gaitwright {

/// The robot's body in standing or crouching. The feet are no farther below it than the legs' speeds allow.
StandingBody CarriedBody(const RobotModel& model, const Crouch* crouch);

/// Whether feet may move on their patches and to other patches: requested, and on ground that is not flat.
bool HasFreeFootholds(const MotionTask& task);

/// Rules for feet without soles on patches: as far from edges as they may roll, on slopes that are not too steep, up to
/// a quarter of the leg length from the given position. The task outlives the rules.
PatchRules WalkPatchRules(const MotionTask& task);

/// The patch of each stance of a walk's problem; -1 if the stance is fixed.
std::vector<int> PatchesOf(const MotionTask& task, const RigidBodyProblem& problem);

/// A walk as a problem for a single rigid body before the motion of its legs is known: ProblemOf with the friction that
/// a plan may use, the largest rising speed of the motors, and the swings.
RigidBodyProblem WalkProblem(const MotionTask& task, const StandingBody& body, const Crouch* crouch,
                             const FlightSwings& shapes);

/// Options for this problem (FittedOptions), with nodes on the plan's grid.
RigidBodyOptions WalkOptions(const MotionTask& task, const RigidBodyProblem& problem);

}  // namespace gaitwright
