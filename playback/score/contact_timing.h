// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "playback/log/playback_log.h"

namespace gaitwright {

/// A swing of the schedule that has a stance on both sides.
struct ScheduledSwing {
  int foot = 0;
  double liftoff_s = 0.0, touchdown_s = 0.0;
};

std::vector<ScheduledSwing> SwingsOf(const ContactSchedule& schedule, int num_feet);

/// The stays of one foot on the ground as measured, with gaps shorter than `bridge_s` closed.
std::vector<ContactInterval> MeasuredIntervals(const PlaybackLog& log, int foot, double bridge_s);

/// A touch-down or lift-off of the schedule against what was measured.
struct TimingError {
  int foot = 0;
  double scheduled_s = 0.0;
  double error_s = 0.0;  ///< measured minus scheduled: late is positive
  bool touchdown = false;
  bool missed = false;  ///< the foot did not touch during the whole stance; error_s is the stance's length
};

/// Every touch-down and lift-off of the schedule up to `end_s`, but the start and the end of the motion. Each scheduled
/// stance is compared with the measured one that overlaps it most.
std::vector<TimingError> TimingErrors(const ContactSchedule& schedule, const PlaybackLog& log, int num_feet,
                                      double end_s);

/// Swings in which the foot touched further than `ends_s` from both ends, up to `end_s`.
std::vector<ScheduledSwing> ScuffedSwings(const ContactSchedule& schedule, const PlaybackLog& log, int num_feet,
                                          double ends_s, double end_s);

/// Gaps in contact shorter than this are one stance; contact this far from the ends of a swing is a scuff [s]. It is
/// the gate of contact_timing_error_max_s.
double TimingGate();

}  // namespace gaitwright
