// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "playback/score/measurements.h"
#include "playback/score/metric.h"

namespace gaitwright {

/// Disturbances of a playback that its plan did not know, as text, from its log: "a push of 60 N to the left from 3.00
/// s for 0.10 s", "a slope of 2 degrees". Pushes that began after `before_s` are omitted; of the earlier pushes only
/// the last two are listed. Empty for an undisturbed playback.
std::vector<std::string> DisturbancesOf(const MotionPlan& plan, const PlaybackLog& log,
                                        double before_s = std::numeric_limits<double>::infinity());

/// The reason for the verdict in one plain sentence. For a fall, its cause and up to three earlier events; for a
/// failure without a fall, the broken gates; for a pass, the gate with the largest share of its upper limit.
std::string ReasonOf(const ScoreInputs& in, const std::vector<Metric>& metrics);

/// A cause in words that many playbacks can share. For a fall, the first event in its last second ("a foot slid"), or
/// the kind of the fall if there is no event ("the base tilted"). For a failure without a fall, the first broken gate
/// ("slip_max_step_m"). Empty for a pass.
std::string CauseOf(const ScoreInputs& in, const std::vector<Metric>& metrics);

/// Whether CauseOf can return this cause for a fall.
bool IsCauseOfFall(const std::string& cause);

}  // namespace gaitwright
