// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>

#include "playback/log/playback_log.h"
#include "playback/score/stability_report.h"

namespace gaitwright::examples {

/// Result of standing up from lying.
struct StoodUp {
  PlaybackLog log;
  StabilityReport report;
  double zmp_error_m = 0.0;  ///< distance of the measured ZMP from the planned ZMP at the end
};

/// A built-in robot stands up from its belly, in four phases. Each phase ends on a measured condition; until it is met,
/// the plan's clock waits.
/// @param on_phase  called when a phase ends.
/// @throws InvalidArgument if the robot has no lying posture.
StoodUp StandUp(const std::string& robot, const std::function<void(const GateRecord&)>& on_phase);

}  // namespace gaitwright::examples
