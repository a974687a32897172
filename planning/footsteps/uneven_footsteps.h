// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "planning/footsteps/plan_footsteps.h"

namespace gaitwright {

/// Steps of the base for counted footfalls on level ground, where the last ones close the stance; 0 or less if they
/// only close it.
int StepsAhead(const Gait& gait, int footfalls);

/// A command of a distance without speeds as counted footfalls: as few cycles of the gait as reach that far with
/// strides of at most stride_m, all of one length. Any other command is unchanged, and any if stride_m is not above 0.
WalkCommand CountedByStride(const Gait& gait, double stride_m, const WalkCommand& command);

/// Search problem of a command: its course in plan view, at the stride of the gait at the commanded speed. Failures as
/// of MakeCourse; kBadInput also for too few counted footfalls to move.
Result<FootstepQuery> CourseQuery(const RobotModel& model, const Gait& gait, const WalkCommand& command,
                                  const FootstepOptions& options);

/// Schedule, footholds and base path of the footfalls that a search finds. The base is over its feet (FitBase, at their
/// mean heading) half way between a touch-down and the next lift-off, and moves smoothly between.
/// Failures as of SearchFootsteps and ScheduleContacts.
Result<FootstepSkeleton> SearchSkeleton(const RobotModel& model, const Terrain& terrain, const FootstepQuery& query,
                                        const FootstepOptions& options);

}  // namespace gaitwright
