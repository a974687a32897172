// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "workflows/compare/compare_reports.h"

namespace gaitwright {

/// "position of FL_hip_joint differs first, at 0.42 s: 0.10 against 0.13 rad (tolerance 0.012)", or a text that says
/// that nothing differs.
std::string FirstDifferenceText(const MotionComparison& comparison);

/// Differences in text values for readers, because two motions of different origin may share no option.
struct FoldedWords {
  std::vector<WordDifference> each;
  std::string only_a, only_b;  ///< options in groups that the other side does not have: "terrain, swing.*"
};

/// Summarises options that only one side has, by group.
FoldedWords Folded(const std::vector<WordDifference>& words);

/// Text for readers: first difference, then joints, base, balance, feet, metrics and provenance.
std::string ComparisonText(const MotionComparison& comparison, const std::vector<MetricPair>& metrics);
std::string ComparisonText(const ReportComparison& comparison);

/// The stable object of `compare` (docs/json-output.md); the caller adds its files.
std::string ComparisonJson(const MotionComparison& comparison, const std::vector<MetricPair>& metrics);
std::string ComparisonJson(const ReportComparison& comparison);

/// One self-contained HTML page, with both motions in the same plots.
std::string ComparisonPage(const ComparedMotion& a, const ComparedMotion& b, const MotionComparison& comparison,
                           const std::vector<MetricPair>& metrics);
/// The page of two reports: tables only.
std::string ComparisonPage(const ReportComparison& comparison);

}  // namespace gaitwright
