// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "optimisation/pipeline/motion_passes.h"
#include "planning/footsteps/plan_sequence.h"

namespace gaitwright {

/// Whether the gait of any part turns the body over.
bool TurnsOver(const std::vector<WalkPart>& parts);

/// Standing time that the crouches before and after a turn need [s].
double StandingForTurn(const RobotModel& model);

/// Options of the whole-body optimisation of a turn, whose first guess is far from a motion that balances.
TrajectoryOptions TurningOptions(TrajectoryOptions options);

/// First guess of a motion in which the body turns over once: all feet swing once, with one flight.
/// Failure kInfeasible for other contacts, for several parts, for ground that is not flat, and if legs do not reach.
Result<MotionPass> GuessTurn(const MotionTask& task);

}  // namespace gaitwright
