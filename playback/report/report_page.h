// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/base/options.h"
#include "playback/log/playback_log.h"
#include "playback/score/stability_report.h"

namespace gaitwright {

/// What a report says that no log knows.
struct ReportWords {
  std::vector<std::string> audit_lines;       ///< plain sentences of the plan's audit; none hides the section
  std::vector<OptionChange> changed_options;  ///< of plan and playback, beside their usual values
  std::string objection;    ///< why it is a fail whatever physics said, such as a failed audit; empty for none
  std::string viewer = {};  ///< the motion in 3D, as ViewerPart has it; empty for none
};

/// What a page about a motion is headed: "a1: trot on flat ground".
std::string TitleOf(const RobotModel& model, const MotionPlan& plan);

/// The report of one playback as a single HTML page: verdict, figures, plots, the audit's words, and what made it.
/// Whole by itself: no network, and no script but that of the viewer; light and dark by the reader's own setting.
/// Well-formed XML.
/// @throws InvalidArgument as Score does.
std::string ReportPage(const RobotModel& model, const MotionPlan& plan, const PlaybackLog& log,
                       const StabilityReport& report, const ReportWords& words = {});

}  // namespace gaitwright
