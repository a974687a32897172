// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/base/result.h"
#include "planning/plan/gait.h"

namespace gaitwright {

/// How long, or how many footfalls, a gait is to go on.
struct ScheduleRequest {
  double initial_stand_s = 0.8;  ///< all feet on the ground before the first lift-off
  double final_stand_s = 0.8;    ///< and after the last touch-down
  double stepping_s = 1.0;       ///< time in which swings may start, from the first lift-off
  int footfalls = 0;             ///< > 0: exactly so many swings instead, in the gait's order
  int first_foot = -1;           ///< the foot that swings first; -1 for the gait's own
  double grid_s = 0.005;         ///< every boundary is a multiple of it
};

/// The schedule of a gait that starts and ends standing on all feet. Each foot's last swing brings it beside the
/// others. Times are rounded to the grid, those that fall together alike. Phases may be flights, and feet may lift just
/// as others land. Failure kBadInput when a swing or stance would be shorter than two steps of the grid.
Result<ContactSchedule> ScheduleContacts(const Gait& gait, const ScheduleRequest& request);

}  // namespace gaitwright
