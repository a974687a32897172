// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "kinematics/base/options.h"
#include "playback/log/playback_log.h"
#include "playback/score/agreement.h"
#include "playback/score/stability_report.h"

namespace gaitwright {

/// The same plan played in another physics engine.
struct SecondVerdict {
  const PlaybackLog& log;
  const StabilityReport& report;
  const Agreement& agreement;
};

/// Data of a report that is not in the log.
struct ReportWords {
  std::vector<std::string> audit_lines;  ///< plain sentences of the plan's audit; without any the section is hidden
  std::vector<OptionChange> changed_options;  ///< of plan and playback, with their default values
  std::string objection;    ///< reason of a fail independent of physics, such as a failed audit; else empty
  std::string orbit = {};   ///< orbit stability, as returned by OrbitPart; else empty
  std::string viewer = {};  ///< the motion in 3D, as returned by ViewerPart; else empty
  std::optional<SecondVerdict> second = {};  ///< its verdict, metrics and curves are shown beside the first
};

/// Title of a page about a motion: "a1: trot on flat ground".
std::string TitleOf(const RobotModel& model, const MotionPlan& plan);

/// The report of a playback as a single HTML page: verdict, metrics, plots, the audit's sentences, and provenance. The
/// verdict is a pass if all playbacks pass. Self-contained: no network, and no script except the viewer's. Light or
/// dark by the reader's setting. Well-formed XML.
/// @throws InvalidArgument as Score does.
std::string ReportPage(const RobotModel& model, const MotionPlan& plan, const PlaybackLog& log,
                       const StabilityReport& report, const ReportWords& words = {});

}  // namespace gaitwright
