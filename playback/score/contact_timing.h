// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "playback/log/playback_log.h"

namespace gaitwright {

/// A swing of the schedule between two stances.
struct ScheduledSwing {
  int foot = 0;
  double liftoff_s = 0.0, touchdown_s = 0.0;
};

std::vector<ScheduledSwing> SwingsOf(const ContactSchedule& schedule, int num_feet);

/// Measured stances of one foot; gaps shorter than `bridge_s` are closed.
std::vector<ContactInterval> MeasuredIntervals(const PlaybackLog& log, int foot, double bridge_s);

/// Timing of a touch-down or lift-off of the schedule, compared with the measurement.
struct TimingError {
  int foot = 0;
  double scheduled_s = 0.0;
  double error_s = 0.0;  ///< measured minus scheduled: late is positive
  bool touchdown = false;
  bool missed = false;  ///< the foot did not touch during the whole stance; error_s is the stance's length
};

/// Errors of all touch-downs and lift-offs of the schedule up to `end_s`, except the start and the end of the motion.
/// Each scheduled stance is compared with the measured one that overlaps it most.
std::vector<TimingError> TimingErrors(const ContactSchedule& schedule, const PlaybackLog& log, int num_feet,
                                      double end_s);

/// Swings up to `end_s` in which the foot touched the ground more than `ends_s` from both ends of the swing.
std::vector<ScheduledSwing> ScuffedSwings(const ContactSchedule& schedule, const PlaybackLog& log, int num_feet,
                                          double ends_s, double end_s);

/// Limit of contact_timing_error_max_s [s]. Gaps in contact shorter than this do not end a stance. Contact farther than
/// this from both ends of a swing is a scuff.
double TimingGate();

}  // namespace gaitwright
