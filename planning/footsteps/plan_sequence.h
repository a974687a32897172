// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "planning/footsteps/plan_footsteps.h"

namespace gaitwright {

/// A part of a walk: a gait with a command relative to the end of the previous part, or StandingGait with a duration.
struct WalkPart {
  Gait gait;
  WalkCommand command;

  bool operator==(const WalkPart&) const = default;
};

/// Base path, contact schedule and footholds of consecutive parts, from standing to standing. A single part gives the
/// result of PlanFootsteps.
///
/// Before a part that stands still, the last swings bring the feet beside each other, and the base is at rest during
/// the part. Between two consecutive gaits the base does not stop: its speed changes within a ramp of the slower gait,
/// and the feet change to the new gait around that ramp (JoinSchedules). Each foothold is the foot's standing position
/// under the base at the middle of its stance. The number of counted footfalls is as requested, and they cover the same
/// distance as in a separate plan. Standing still as the first or last part replaces the standing times of the options.
///
/// Failures: as for PlanFootsteps; kBadInput for a command with a goal, and for standing still for less than 0.1 s. The
/// message names the part by number and gait.
Result<FootstepSkeleton> PlanSequence(const RobotModel& model, const Terrain& terrain,
                                      const std::vector<WalkPart>& parts, const FootstepOptions& options);

/// The failure with the name of the part before its message: "part 2, 'bound': ...".
Failure OfPart(std::size_t index, const std::string& gait, Failure failure);

}  // namespace gaitwright
