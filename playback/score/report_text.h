// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "playback/score/agreement.h"
#include "playback/score/stability_report.h"

namespace gaitwright {

/// Text report: the verdict, the score, the reason, and a table of the metrics with planned values and limits.
std::string ReportText(const StabilityReport& report);

/// Text report of one plan in two engines: the overall verdict with the lower score, the verdict of each engine, where
/// the engines differ first, and their metrics side by side.
/// @param agreement  of the two engines; its names are the column titles.
std::string ReportText(const StabilityReport& report, const StabilityReport& second, const Agreement& agreement);

/// The stable JSON object of `walk` and `play`: robot, verdict, score, reason, metrics {KEY: {value, planned, unit,
/// limit, pass, at_s}}, notes. Missing values are null, with the reason in `not_applied`. `pass` is false only if an
/// applied gate was violated. The caller adds files and times.
std::string ReportJson(const StabilityReport& report);

/// A value for people: "23.4 mm", "1.2 %", "0.31 rad", "yes". Lengths below 1 m in mm.
std::string FigureText(const Metric& metric, double value);

/// The limit for people: "<= 40 ms", "> 0 mm"; "-" without a limit, "n/a" if the gate does not apply.
std::string LimitText(const Metric& metric);

}  // namespace gaitwright
