// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "playback/report/report_page.h"

namespace gaitwright {

/// The verdicts of one or two engines as a table, and for two engines where they differ first and the differences by
/// quantity. Uses no samples of the logs.
std::string EngineVerdicts(const PlaybackLog& log, const StabilityReport& report,
                           const std::optional<SecondVerdict>& second);

/// The part of a report page about two engines: the verdict of each, where they differ first, the differences by
/// quantity, and curves of both engines in the same plots.
/// @throws InvalidArgument as MakeMotionSeries does.
std::string EnginesPart(const RobotModel& model, const MotionPlan& plan, const PlaybackLog& log,
                        const StabilityReport& report, const SecondVerdict& second);

}  // namespace gaitwright
