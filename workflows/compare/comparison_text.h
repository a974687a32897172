// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "workflows/compare/compare_reports.h"

namespace gaitwright {

/// "position of FL_hip_joint differs first, at 0.42 s: 0.10 against 0.13 rad (tolerance 0.012)", or that none does.
std::string FirstDifferenceText(const MotionComparison& comparison);

/// Differences in words as people are told them, since two motions that were made in two ways may share no option.
struct FoldedWords {
  std::vector<WordDifference> each;
  std::string only_a, only_b;  ///< the options of groups that the other side does not have: "terrain, swing.*"
};

/// Puts the options of one side alone together, group by group.
FoldedWords Folded(const std::vector<WordDifference>& words);

/// For people: what differed first, then joint by joint, base, balance, feet, figures and what made them.
std::string ComparisonText(const MotionComparison& comparison, const std::vector<MetricPair>& metrics);
std::string ComparisonText(const ReportComparison& comparison);

/// The stable object of `compare` (docs/json-output.md); the caller adds its files.
std::string ComparisonJson(const MotionComparison& comparison, const std::vector<MetricPair>& metrics);
std::string ComparisonJson(const ReportComparison& comparison);

/// One HTML page, whole by itself, with both motions drawn on top of each other.
std::string ComparisonPage(const ComparedMotion& a, const ComparedMotion& b, const MotionComparison& comparison,
                           const std::vector<MetricPair>& metrics);
/// The same of two reports: tables alone.
std::string ComparisonPage(const ReportComparison& comparison);

}  // namespace gaitwright
