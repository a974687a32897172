// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "playback/score/stability_report.h"
#include "workflows/walk/engine_verdict.h"

namespace gaitwright {

/// A measure of a check: its better direction, and its default value for full points, if there is one.
struct MeasureRule {
  bool higher_is_better = true;
  std::optional<double> usual_full_at;
};

/// Names of measures of motions: pass, stands, audit, score, survival, and the keys of MetricRules().
std::vector<std::string> MotionMeasureNames();

/// @throws InvalidArgument for an unknown name.
MeasureRule RuleOfMeasure(const std::string& measure);

/// Outcome of one run of a part.
struct RunOutcome {
  std::string title;                      ///< description of the run: "run 1: flat, speed_m_s=0.3"
  std::string failure;                    ///< why there is no motion to play; "" if there is one
  std::optional<StabilityReport> report;  ///< of the playback without disturbances
  bool audit_passes = false;
  std::string audit_words;  ///< why it fails, in one line
  int trials = 0, survived = 0;
  std::vector<std::string> falls = {};      ///< the first trials that fell: disturbances and reason of each fall
  std::vector<EngineVerdict> engines = {};  ///< verdicts on the playback without disturbances, if two engines played it
};

/// A measure over all runs: for shares, the share of the runs or of all their trials; otherwise the worst value of all
/// runs, and nothing if a run has no value or fell (except for measures of falls).
std::optional<double> MeasureOf(const std::string& measure, bool higher_is_better, const std::vector<RunOutcome>& runs);

}  // namespace gaitwright
