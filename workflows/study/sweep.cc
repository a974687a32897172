// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/study/sweep.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace gaitwright {
namespace {

std::string UnitAfter(const StudyAxis& axis) { return axis.unit.empty() || axis.unit == "1" ? "" : " " + axis.unit; }

/// "speed 0.9 to 1.2 m/s" of the values that the points have on an axis.
std::string Covered(const Study& study, std::size_t axis, const std::vector<std::size_t>& points) {
  const StudyAxis& a = study.axes[axis];
  std::vector<std::string> values;
  for (const std::size_t point : points) values.push_back(study.points[point][axis]);
  if (a.numbers) {
    const auto by_value = [](const std::string& x, const std::string& y) {
      return NumberOfValue(x) < NumberOfValue(y);
    };
    const auto [low, high] = std::minmax_element(values.begin(), values.end(), by_value);
    return *low == *high ? fmt::format("{} {}{}", a.key, *low, UnitAfter(a))
                         : fmt::format("{} {} to {}{}", a.key, *low, *high, UnitAfter(a));
  }
  const std::set<std::string> each(values.begin(), values.end());
  return fmt::format("{} {}", a.key, fmt::join(each, " or "));
}

}  // namespace

SweepSummary SummaryOf(const std::vector<PointOutcome>& outcomes) {
  SweepSummary summary;
  const PointOutcome* best = nullptr;
  for (const PointOutcome& outcome : outcomes) {
    ++summary.counts[static_cast<std::size_t>(outcome.status)];
    if (outcome.audit_pass() && (best == nullptr || IsBetter(outcome, *best))) best = &outcome;
  }
  if (best != nullptr) summary.best = best->point;
  return summary;
}

std::vector<FailureGroup> FailureGroups(const Study& study, const std::vector<PointOutcome>& outcomes) {
  std::vector<FailureGroup> groups;
  for (const PointOutcome& outcome : outcomes) {
    if (outcome.status == PointStatus::kPass) continue;
    auto group = std::find_if(groups.begin(), groups.end(), [&](const FailureGroup& g) {
      return g.status == outcome.status && g.code == outcome.code;
    });
    if (group == groups.end()) {
      groups.push_back({outcome.status, outcome.code, {}, "", outcome.reason});
      group = groups.end() - 1;
    }
    group->points.push_back(outcome.point);
  }
  for (FailureGroup& group : groups) {
    for (std::size_t k = 0; k < study.axes.size(); ++k)
      group.where += (k == 0 ? "" : ", ") + Covered(study, k, group.points);
  }
  std::stable_sort(groups.begin(), groups.end(),
                   [](const auto& a, const auto& b) { return a.points.size() > b.points.size(); });
  return groups;
}

}  // namespace gaitwright
