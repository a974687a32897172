// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/grade/motion_measures.h"

#include <algorithm>

#include "playback/score/gates.h"

namespace gaitwright {
namespace {

/// Measures that are shares of runs or trials.
const std::vector<std::string> kShares = {"pass", "stands", "audit", "survival"};

bool Fell(const StabilityReport& report) { return report.At("fell").value.value_or(1.0) != 0.0; }

/// Whether a run counts for a share.
bool Holds(const std::string& measure, const RunOutcome& run) {
  if (measure == "audit") return run.failure.empty() && run.audit_passes;
  if (!run.report) return false;
  return measure == "pass" ? run.report->pass : !Fell(*run.report);
}

std::optional<double> Survival(const std::vector<RunOutcome>& runs) {
  int trials = 0, survived = 0;
  for (const RunOutcome& run : runs) {
    trials += run.trials;
    survived += run.survived;
  }
  return trials == 0 ? std::nullopt : std::optional<double>(static_cast<double>(survived) / trials);
}

/// A value of one run; for a run that fell, only the measures of falls and the score count.
std::optional<double> ValueIn(const std::string& measure, const RunOutcome& run) {
  if (!run.report) return std::nullopt;
  if (measure == "score") return run.report->score;
  const bool of_falls = measure == "fell" || measure == "time_to_fall_s";
  if (Fell(*run.report) && !of_falls) return std::nullopt;
  return run.report->At(measure).value;
}

}  // namespace

std::vector<std::string> MotionMeasureNames() {
  std::vector<std::string> names = kShares;
  names.emplace_back("score");
  for (const MetricRule& rule : MetricRules()) names.push_back(rule.key);
  return names;
}

MeasureRule RuleOfMeasure(const std::string& measure) {
  if (std::find(kShares.begin(), kShares.end(), measure) != kShares.end()) return {true, 1.0};
  if (measure == "score") return {true, {}};
  return {RuleOf(measure).better != Better::kLower, {}};
}

std::optional<double> MeasureOf(const std::string& measure, bool higher_is_better,
                                const std::vector<RunOutcome>& runs) {
  if (measure == "survival") return Survival(runs);
  if (std::find(kShares.begin(), kShares.end(), measure) != kShares.end()) {
    const auto holds =
        std::count_if(runs.begin(), runs.end(), [&](const RunOutcome& run) { return Holds(measure, run); });
    return static_cast<double>(holds) / static_cast<double>(runs.size());
  }
  std::optional<double> worst;
  for (const RunOutcome& run : runs) {
    const std::optional<double> value = ValueIn(measure, run);
    if (!value) return std::nullopt;
    const bool worse = worst && (higher_is_better ? *value < *worst : *value > *worst);
    if (!worst || worse) worst = value;
  }
  return worst;
}

}  // namespace gaitwright
