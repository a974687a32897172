// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "planning/footsteps/plan_footsteps.h"

namespace gaitwright {

/// A part of a walk: a gait with a command relative to the end of the part before, or StandingGait with a duration.
struct WalkPart {
  Gait gait;
  WalkCommand command;

  bool operator==(const WalkPart&) const = default;
};

/// Base path, contact schedule and footholds of consecutive parts, from standing to standing. For a single part, those
/// of PlanFootsteps.
///
/// Before a part that stands still the last swings bring the feet beside each other, and the base is at rest for so
/// long. Where two gaits follow each other the base goes on: it changes from one speed to the other within a ramp of
/// the slower of both, around which the feet change over too (JoinSchedules), and each foothold is where the foot
/// stands under the base at the middle of its stance. Counted footfalls are as many as asked for, and lead as far as
/// they do alone. A part of standing still that begins or ends the walk takes the place of the times in the options.
///
/// Failures: as of PlanFootsteps; kBadInput for a command of a goal, and for a part that stands still for less than
/// 0.1 s. That of a part names it by its number and gait.
Result<FootstepSkeleton> PlanSequence(const RobotModel& model, const Terrain& terrain,
                                      const std::vector<WalkPart>& parts, const FootstepOptions& options);

/// The failure with the name of the part before its message: "part 2, 'bound': ...".
Failure OfPart(std::size_t index, const std::string& gait, Failure failure);

}  // namespace gaitwright
