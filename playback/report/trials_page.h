// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "playback/report/plots.h"
#include "playback/trials/robustness_report.h"

namespace gaitwright {

/// Plots of a run of trials: pushes (polar, if anything pushes), survival_by_cause (over the strongest correlate of
/// falling, if any robot fell), gates (distribution of the metrics with limits), scores (sorted).
std::vector<Plot> TrialPlots(const RobustnessReport& report);

/// The report of a run of trials as a single HTML page, like ReportPage: survival with its interval, plots, causes, the
/// ranking of disturbances, metrics, the worst trials and how to repeat each. Self-contained; well-formed XML;
/// deterministic to the byte.
std::string TrialsPage(const RobustnessReport& report);

}  // namespace gaitwright
