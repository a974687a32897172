// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/base/result.h"
#include "planning/plan/gait.h"

namespace gaitwright {

/// Duration of a gait, or its number of footfalls.
struct ScheduleRequest {
  double initial_stand_s = 0.8;  ///< all feet on the ground before the first lift-off
  double final_stand_s = 0.8;    ///< all feet on the ground after the last touchdown
  double stepping_s = 1.0;       ///< time in which swings may start, from the first lift-off
  int footfalls = 0;             ///< > 0: exactly this number of swings instead of stepping_s, in the gait's order
  int first_foot = -1;           ///< foot that swings first; -1 for the first foot of the gait
  double grid_s = 0.005;         ///< time step; each boundary is a multiple of it
};

/// The contact schedule of a gait that starts and ends with all feet on the ground. The last swing of each foot brings
/// it beside the others. Times are rounded to the grid; equal times stay equal. Phases may be flights, and feet may
/// lift exactly when others land. Failure kBadInput if a swing or stance would be shorter than two steps of the grid.
Result<ContactSchedule> ScheduleContacts(const Gait& gait, const ScheduleRequest& request);

/// One gait, or standing still, as a part of a longer schedule.
struct GaitStint {
  Gait gait;
  double time_s = 1.0;  ///< time in which swings may start, from the first lift-off; the duration of standing still
  int footfalls = 0;    ///< > 0: exactly this number of swings instead of time_s, in the gait's order
  int first_foot = -1;  ///< foot that swings first; -1 for the first foot of the gait
};

/// Grid of a schedule of several stints, and its standing times before the first lift-off and after the last touchdown
/// (unused if the schedule begins or ends with standing still).
struct ScheduleEnds {
  double initial_stand_s = 0.8, final_stand_s = 0.8;
  double grid_s = 0.005;
};

/// A schedule of several stints. Each stint lasts until the next one starts.
struct JoinedSchedule {
  ContactSchedule schedule;
  std::vector<double> start_s;  ///< by stint: start of standing still, or first lift-off of a gait
};

/// The schedule of several consecutive gaits. After standing, each gait begins as in ScheduleContacts. A gait that
/// follows another gait begins with the foot that allows the earliest start: each foot first stays on the ground for
/// the shorter of its stance times in the two gaits, so all feet are on the ground together for a while or for an
/// instant. Failure kBadInput as for ScheduleContacts, and if `stints` contains no gait.
Result<JoinedSchedule> JoinSchedules(const std::vector<GaitStint>& stints, const ScheduleEnds& ends);

}  // namespace gaitwright
