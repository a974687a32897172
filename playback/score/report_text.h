// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "playback/score/agreement.h"
#include "playback/score/stability_report.h"

namespace gaitwright {

/// Text report: the verdict, the score, the reason, and a table of the metrics with planned values and limits.
std::string ReportText(const StabilityReport& report);

/// Text report of one plan in two engines: the verdict of both, which has the lower score, that of each, where they
/// part, and the metrics side by side.
/// @param agreement  of the two, whose names head the columns.
std::string ReportText(const StabilityReport& report, const StabilityReport& second, const Agreement& agreement);

/// The stable object of `walk` and `play`: robot, verdict, score, reason, metrics {KEY: {value, planned, unit, limit,
/// pass, at_s}}, notes. Missing values are null, with the reason in `not_applied`; `pass` is false only where an
/// applied gate broke. The caller adds its files and times.
std::string ReportJson(const StabilityReport& report);

/// A figure for people: "23.4 mm", "1.2 %", "0.31 rad", "yes". Lengths below 1 m in mm.
std::string FigureText(const Metric& metric, double value);

/// The limit for people: "<= 40 ms", "> 0 mm"; "-" when there is none, "n/a" when the gate does not apply.
std::string LimitText(const Metric& metric);

}  // namespace gaitwright
