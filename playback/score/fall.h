// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "playback/score/motion_series.h"

namespace gaitwright {

/// Criterion by which a fall was detected.
enum class FallKind {
  kNone,               ///< no fall
  kTilted,             ///< tilt of the base out of bounds
  kLeftHeight,         ///< height of the base out of bounds
  kBodyContact,        ///< a link that is not a foot touched the ground
  kControllerStopped,  ///< the playback ended early because of the controller
  kPhysicsStopped,     ///< the playback ended early because of the physics
  kNotFinite,          ///< a state of the log is not finite
  kEndedEarly,         ///< the log ends before the plan
};

/// The robot's fall, if there is one.
struct Fall {
  bool fell = false;
  double time_s = 0.0;  ///< time of the fall; the end of the log without one
  FallKind kind = FallKind::kNone;
  std::string what = {};  ///< "the base tilted to 0.71 rad, planned 0.02 rad"
};

/// The first of these events. A base tilt that differs from the plan by more than `fall_tilt_rad` (angle between the
/// two up directions in the base frame, independent of yaw). A base height out of its bounds, measured above the stance
/// feet or, in flight, above the ground of the take-off. A ground contact of a link that is not a foot. An early end of
/// the playback, which takes precedence over its last sample. A state that is not finite. A log that ends before the
/// plan.
Fall FindFall(const MotionPlan& plan, const PlaybackLog& log, const MotionSeries& series, const ScoreOptions& options);

}  // namespace gaitwright
