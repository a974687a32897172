// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "playback/score/measurements.h"
#include "playback/score/metric.h"

namespace gaitwright {

/// Disturbances of a playback that its plan did not know, as text, from its log: "a push of 60 N to the left from 3.00
/// s for 0.10 s", "a slope of 2 degrees". Pushes that began after a time are left out, and of those before it all but
/// the last two. Empty for a plain playback.
std::vector<std::string> DisturbancesOf(const MotionPlan& plan, const PlaybackLog& log,
                                        double before_s = std::numeric_limits<double>::infinity());

/// The reason for the verdict in one plain sentence: for a fall what ended it and up to three events that came before,
/// for a failure without a fall the gates that broke, for a pass the gate that is nearest to its limit.
std::string ReasonOf(const ScoreInputs& in, const std::vector<Metric>& metrics);

/// What many playbacks may have in common: of a fall the first event in its last second ("a foot slid"), or without one
/// how it ended ("the base tilted"); of a failure without a fall the first broken gate ("slip_max_step_m"); empty for a
/// pass.
std::string CauseOf(const ScoreInputs& in, const std::vector<Metric>& metrics);

/// Whether CauseOf can return this cause for a fall.
bool IsCauseOfFall(const std::string& cause);

}  // namespace gaitwright
