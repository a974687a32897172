// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/base/result.h"
#include "workflows/compare/compare_motions.h"

namespace gaitwright {

/// A figure of a report as its JSON has it.
struct ReportedFigure {
  std::string key, unit;
  std::optional<double> value;  ///< a boolean as 0 or 1
  std::optional<double> limit;
  bool pass = true;
};

/// What `walk --json` and `play --json` print, and ReportJson, as far as reports are compared.
struct ReadReport {
  std::string name;  ///< the file
  std::string robot, verdict, reason;
  double score = 0.0;
  std::vector<ReportedFigure> metrics;
  std::vector<std::string> violations;  ///< laws of the audit that are broken, each once
};

/// A report of its JSON text. Failure kBadInput `report_file` naming the key that is missing or of the wrong kind.
Result<ReadReport> ReportFromJson(const std::string& text, const std::string& source);

/// A metric of both; nothing where a report has none.
struct MetricPair {
  std::string key, unit;
  std::optional<double> a, b, limit;
  bool pass_a = true, pass_b = true;
  bool differs = false;  ///< by more than the tolerance, or the one passes and the other does not
};

/// Two reports side by side.
struct ReportComparison {
  std::string name_a, name_b;
  double score_a = 0.0, score_b = 0.0;
  std::vector<MetricPair> metrics;
  std::vector<WordDifference> words;  ///< robot, verdict, reason, laws that the audit finds broken

  /// No metric and no word differs.
  bool same() const;
};

/// A metric differs where it is apart by more than `tolerance` times the larger magnitude of both and of the limit, or
/// where one side has none.
ReportComparison CompareReports(const ReadReport& a, const ReadReport& b, double tolerance);

/// The metrics of playbacks: of a plan and its log what was planned and what was measured, of two logs of `played`, or
/// of its motion made anew, both as measured. None where there is no plan to score them by or it is of another robot.
std::vector<MetricPair> MetricsOf(const ComparedMotion& a, const ComparedMotion& b, const MotionPlan* played,
                                  double tolerance);

}  // namespace gaitwright
