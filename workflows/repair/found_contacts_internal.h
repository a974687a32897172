// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "planning/plan/terrain.h"
#include "workflows/exchange/even_motion.h"
#include "workflows/exchange/foot_track.h"
#include "workflows/repair/repair_options_internal.h"

namespace gaitwright {

/// Contacts of a motion that may float, sink and slide.
struct FoundContacts {
  double height_m = 0.0;        ///< median height of feet that stand: above zero floats, below it sinks
  std::vector<FootSet> stance;  ///< by row
  int short_stances = 0;        ///< stances that were too short and became part of a swing
  int short_swings = 0;         ///< swings that were too short and became part of a stance
  int false_flights = 0;        ///< times without a foot on the ground in which the robot did not fall
};

/// Finds the feet that stand. A foot begins to stand where it is slow, flat and as low as feet that stand around that
/// time, and begins to swing where it is no longer so by the factor `leave`. Then short swings and short stances are
/// taken away, and times without a foot on the ground in which the base does not fall freely.
FoundContacts FindContacts(const RobotModel& model, const EvenMotion& motion, const std::vector<FootTrack>& feet,
                           const RepairOptions& options);

/// First and last rows of stances of a foot.
struct RowRange {
  int first = 0, last = 0;
};
std::vector<RowRange> StancesOf(const std::vector<FootSet>& stance, int foot);

}  // namespace gaitwright
