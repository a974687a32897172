// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "playback/report/plots.h"
#include "playback/trials/robustness_report.h"

namespace gaitwright {

/// Plots of a run of trials: pushes (polar, where anything pushes), survival_by_cause (over what falls go with most,
/// where any robot fell), gates (spread of what has a limit), scores (sorted).
std::vector<Plot> TrialPlots(const RobustnessReport& report);

/// The report of a run of trials as a single HTML page, in the manner of ReportPage: survival with its interval, plots,
/// causes, the ranking of disturbances, metrics, the worst trials and how to repeat each. Whole by itself; well-formed
/// XML; the same report gives the same bytes.
std::string TrialsPage(const RobustnessReport& report);

}  // namespace gaitwright
