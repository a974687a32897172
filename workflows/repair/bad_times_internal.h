// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "workflows/repair/repair_motion_internal.h"

namespace gaitwright {

/// Times of the file's motion that cannot be met at their speed.
struct BadTimes {
  std::vector<double> file_s;
  std::string why;      ///< half a sentence
  bool is_far = false;  ///< the plan is sound, but not near the motion
  bool played = false;  ///< the proof was asked for
};

/// The first of these that is found: times without a solution, times at which the plan fails its audit, times at which
/// its joints are far from the clean motion (`stretch_over_rad`), and the second before the fall in physics.
BadTimes BadTimesOf(const RepairOptions& options, const MotionFindings& findings,
                    const Result<RepairedMotion>& repaired, const FollowReport& report, const PlanProof& proof);

}  // namespace gaitwright
