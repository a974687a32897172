// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/base/result.h"
#include "workflows/compare/compare_motions.h"

namespace gaitwright {

/// A metric of a report, as in its JSON.
struct ReportedFigure {
  std::string key, unit;
  std::optional<double> value;  ///< a boolean as 0 or 1
  std::optional<double> limit;
  bool pass = true;
};

/// The parts of a report (output of `walk --json`, `play --json` and ReportJson) that are compared.
struct ReadReport {
  std::string name;  ///< the file
  std::string robot, verdict, reason;
  double score = 0.0;
  std::vector<ReportedFigure> metrics;
  std::vector<std::string> violations;  ///< failed checks of the audit, each once
};

/// Reads a report from its JSON text. Failure kBadInput `report_file` names the key that is missing or has the wrong
/// type.
Result<ReadReport> ReportFromJson(const std::string& text, const std::string& source);

/// A metric of both reports; nothing if a report has none.
struct MetricPair {
  std::string key, unit;
  std::optional<double> a, b, limit;
  bool pass_a = true, pass_b = true;
  bool differs = false;  ///< by more than the tolerance, or only one passes
};

/// Comparison of two reports.
struct ReportComparison {
  std::string name_a, name_b;
  double score_a = 0.0, score_b = 0.0;
  std::vector<MetricPair> metrics;
  std::vector<WordDifference> words;  ///< robot, verdict, reason, failed checks of the audit

  /// True if no metric and no text differs.
  bool same() const;
};

/// Compares two reports. A metric differs if the difference exceeds `tolerance` times the largest magnitude of both
/// values and the limit, or if only one side has a value.
ReportComparison CompareReports(const ReadReport& a, const ReadReport& b, double tolerance);

/// The metrics of playbacks. For a plan and its log: planned and measured values. For two logs of `played`, or of its
/// motion planned again: two measured values. Empty without a plan to score them with, and for a plan of another robot.
std::vector<MetricPair> MetricsOf(const ComparedMotion& a, const ComparedMotion& b, const MotionPlan* played,
                                  double tolerance);

}  // namespace gaitwright
