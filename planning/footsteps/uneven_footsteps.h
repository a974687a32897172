// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "planning/footsteps/plan_footsteps.h"

namespace gaitwright {

/// Number of steps of the base for counted footfalls on level ground, where the last ones close the stance; 0 or less
/// if all of them only close it.
int StepsOfBase(const Gait& gait, int footfalls);

/// Smallest number of equal strides of at most stride_m that cover the distance of a command, or reach its goal; 0 for
/// a command with speeds or with another extent, and if stride_m <= 0.
int LeastStrides(double stride_m, const WalkCommand& command);

/// Converts a command with a distance or a goal to counted footfalls in a number of gait cycles.
WalkCommand CountedInStrides(const Gait& gait, int strides, const WalkCommand& command);

/// Search problem of a command: its course in plan view, at the stride of the gait at the commanded speed. Failures as
/// for MakeCourse; also kBadInput if there are too few counted footfalls to move the robot.
Result<FootstepQuery> CourseQuery(const RobotModel& model, const Gait& gait, const WalkCommand& command,
                                  const FootstepOptions& options);

/// Schedule, footholds and base path for the footfalls that a search finds. Halfway between a touch-down and the next
/// lift-off, the base is above its feet (FitBase, at their mean heading); it moves smoothly in between. Failures as for
/// SearchFootsteps and ScheduleContacts.
Result<FootstepSkeleton> SearchSkeleton(const RobotModel& model, const Terrain& terrain, const FootstepQuery& query,
                                        const FootstepOptions& options);

}  // namespace gaitwright
