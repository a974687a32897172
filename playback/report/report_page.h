// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "playback/log/playback_log.h"
#include "playback/score/stability_report.h"

namespace gaitwright {

/// The report of one playback as a single HTML page: verdict, figures, plots, the audit's words, and what made it.
/// Whole by itself: no network, no scripts; light and dark by the reader's own setting. Well-formed XML.
/// @param audit_lines  plain sentences of the plan's audit; none hides the section.
/// @throws InvalidArgument as Score does.
std::string ReportPage(const RobotModel& model, const MotionPlan& plan, const PlaybackLog& log,
                       const StabilityReport& report, const std::vector<std::string>& audit_lines);

}  // namespace gaitwright
