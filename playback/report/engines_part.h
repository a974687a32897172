// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "playback/report/report_page.h"

namespace gaitwright {

/// The part of a report page about two engines: the verdict of each, where they part first, the differences by
/// quantity, and curves of both over each other.
/// @throws InvalidArgument as of MakeMotionSeries.
std::string EnginesPart(const RobotModel& model, const MotionPlan& plan, const PlaybackLog& log,
                        const StabilityReport& report, const SecondVerdict& second);

}  // namespace gaitwright
