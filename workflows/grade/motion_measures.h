// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "playback/score/stability_report.h"

namespace gaitwright {

/// What a measure of a check is: which way it gets better, and where it is right, where that goes without saying.
struct MeasureRule {
  bool higher_is_better = true;
  std::optional<double> usual_full_at;
};

/// What motions may be measured by: pass, stands, audit, score, survival, and the keys of MetricRules().
std::vector<std::string> MotionMeasureNames();

/// @throws InvalidArgument for a name that is none of them.
MeasureRule RuleOfMeasure(const std::string& measure);

/// What came of one run of a part.
struct RunOutcome {
  std::string title;                      ///< what was walked: "run 1: flat, speed_m_s=0.3"
  std::string failure;                    ///< why there is no motion to play; "" where there is
  std::optional<StabilityReport> report;  ///< of the playback without disturbances
  bool audit_passes = false;
  std::string audit_words;  ///< why it fails, in a line
  int trials = 0, survived = 0;
  std::vector<std::string> falls = {};  ///< of the first trials that fell: how each was disturbed, and why it fell
};

/// A measure over all runs: shares of the runs or of all their trials; else the worst value of any, nothing where a run
/// has none or fell (which its fall itself is measured in spite of).
std::optional<double> MeasureOf(const std::string& measure, bool higher_is_better, const std::vector<RunOutcome>& runs);

}  // namespace gaitwright
