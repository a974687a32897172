// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>

#include "playback/log/playback_log.h"
#include "playback/score/stability_report.h"

namespace gaitwright::examples {

/// A quadruped that got up from lying.
struct StoodUp {
  PlaybackLog log;
  StabilityReport report;
  double zmp_error_m = 0.0;  ///< at the end: of the ZMP as measured, to that of the plan
};

/// Gets a robot that comes with the program up from its belly, in four phases that each end when they are measured to
/// be done: the plan's clock waits at the end of each.
/// @param on_phase  called when a phase ends.
/// @throws InvalidArgument with the reason for a robot that cannot lie.
StoodUp StandUp(const std::string& robot, const std::function<void(const GateRecord&)>& on_phase);

}  // namespace gaitwright::examples
