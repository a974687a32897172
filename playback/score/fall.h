// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "playback/score/motion_series.h"

namespace gaitwright {

/// The end of standing up, if it came.
struct Fall {
  bool fell = false;
  double time_s = 0.0;  ///< when it fell; the end of the log when it did not
  std::string what;     ///< "the base tilted 0.71 rad where the plan has 0.02 rad"
};

/// The first of: base tilted off the plan's by more than `fall_tilt_rad` (angle between the two up directions as the
/// base sees them, whatever the yaw); base height over the feet in stance, in flight over what they took off from, out
/// of its bounds; a contact of a body that is no foot; a playback that broke off, which goes before what its last
/// sample shows; a state that is not finite; a log that ends before the plan.
Fall FindFall(const MotionPlan& plan, const PlaybackLog& log, const MotionSeries& series, const ScoreOptions& options);

}  // namespace gaitwright
