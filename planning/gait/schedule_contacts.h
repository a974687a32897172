// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

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

/// The share that one gait, or standing still, has of a schedule of several.
struct GaitStint {
  Gait gait;
  double time_s = 1.0;  ///< in which swings may start, from its first lift-off; of standing still how long it lasts
  int footfalls = 0;    ///< > 0: exactly so many swings instead, in the gait's order
  int first_foot = -1;  ///< the foot that swings first; -1 for the gait's own
};

/// Standing times of a schedule of several stints before the first lift-off and after the last touch-down, unless it
/// begins or ends with standing still, and its grid.
struct ScheduleEnds {
  double initial_stand_s = 0.8, final_stand_s = 0.8;
  double grid_s = 0.005;
};

/// A schedule of several stints. Each goes on from its start to that of the next.
struct JoinedSchedule {
  ContactSchedule schedule;
  std::vector<double> start_s;  ///< by stint: where standing still begins, or a gait's feet begin to lift
};

/// The schedule of several consecutive gaits. From standing each begins as ScheduleContacts has it. A gait that follows
/// another one begins with the foot that lets it begin first: once all feet are down, and have been for as long as both
/// gaits keep them there, whichever is shorter, so that all of them are down for a while or only for a moment. Failure
/// kBadInput as of ScheduleContacts, and without a gait.
Result<JoinedSchedule> JoinSchedules(const std::vector<GaitStint>& stints, const ScheduleEnds& ends);

}  // namespace gaitwright
