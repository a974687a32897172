// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/study/sweep.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <set>

namespace gaitwright {
namespace {

std::string UnitAfter(const StudyAxis& axis) { return axis.unit.empty() || axis.unit == "1" ? "" : " " + axis.unit; }

/// The values of some points on an axis, such as "speed 0.9 to 1.2 m/s".
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

/// Points as numbers by axis; for words, their position in alphabetical order.
std::vector<std::vector<double>> PlacesOf(const Study& study) {
  std::vector<std::vector<double>> places(study.points.size(), std::vector<double>(study.axes.size()));
  for (std::size_t k = 0; k < study.axes.size(); ++k) {
    std::set<std::string> words;
    for (const auto& point : study.points) words.insert(point[k]);
    for (std::size_t i = 0; i < places.size(); ++i) {
      const std::string& value = study.points[i][k];
      places[i][k] = study.axes[k].numbers ? NumberOfValue(value)
                                           : static_cast<double>(std::distance(words.begin(), words.find(value)));
    }
  }
  return places;
}

/// A range of each axis.
struct Box {
  std::vector<double> low, high;

  bool Holds(const std::vector<double>& place) const {
    for (std::size_t k = 0; k < place.size(); ++k) {
      if (place[k] < low[k] || place[k] > high[k]) return false;
    }
    return true;
  }
  Box With(const std::vector<double>& place) const {
    Box box = *this;
    for (std::size_t k = 0; k < place.size(); ++k) {
      box.low[k] = std::min(low[k], place[k]);
      box.high[k] = std::max(high[k], place[k]);
    }
    return box;
  }
};

/// Splits points with the same failure into groups whose boxes contain no other points, because one range over all of
/// them would include points that pass. After a few boxes, the last group has the remaining points.
std::vector<std::vector<std::size_t>> PartsOf(const std::vector<std::size_t>& members,
                                              const std::vector<std::vector<double>>& places) {
  constexpr std::size_t kMostParts = 4, kMostPoints = 10000;
  if (places.size() > kMostPoints) return {members};  // the time grows with the square of the number of points
  const std::set<std::size_t> all(members.begin(), members.end());
  std::vector<const std::vector<double>*> others;
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (all.count(i) == 0) others.push_back(&places[i]);
  }
  std::vector<std::vector<std::size_t>> parts;
  std::vector<std::size_t> left = members;
  while (!left.empty() && parts.size() + 1 < kMostParts) {
    Box box{places[left.front()], places[left.front()]};
    for (const std::size_t point : left) {
      const Box larger = box.With(places[point]);
      if (std::none_of(others.begin(), others.end(), [&](const auto* other) { return larger.Holds(*other); }))
        box = larger;
    }
    const auto rest =
        std::stable_partition(left.begin(), left.end(), [&](std::size_t point) { return box.Holds(places[point]); });
    parts.emplace_back(left.begin(), rest);
    left.erase(left.begin(), rest);
  }
  if (!left.empty()) parts.push_back(std::move(left));
  return parts;
}

}  // namespace

EngineCounts CountEngines(const std::vector<PointOutcome>& outcomes) {
  EngineCounts counts;
  for (const PointOutcome& outcome : outcomes) {
    if (outcome.engines.size() != 2) continue;
    const EngineVerdict &first = outcome.engines[0], &second = outcome.engines[1];
    counts.first = first.engine;
    counts.second = second.engine;
    int& count = first.pass ? (second.pass ? counts.both_pass : counts.first_alone)
                            : (second.pass ? counts.second_alone : counts.none_pass);
    ++count;
  }
  return counts;
}

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
  std::vector<FailureGroup> by_code, groups;
  std::map<std::size_t, const std::string*> reasons;
  for (const PointOutcome& outcome : outcomes) {
    if (outcome.status == PointStatus::kPass) continue;
    reasons[outcome.point] = &outcome.reason;
    auto same = std::find_if(by_code.begin(), by_code.end(), [&](const FailureGroup& g) {
      return g.status == outcome.status && g.code == outcome.code;
    });
    if (same == by_code.end()) {
      by_code.push_back({outcome.status, outcome.code, {}, "", ""});
      same = by_code.end() - 1;
    }
    same->points.push_back(outcome.point);
  }
  const std::vector<std::vector<double>> places = PlacesOf(study);
  for (const FailureGroup& same : by_code) {
    for (const std::vector<std::size_t>& part : PartsOf(same.points, places)) {
      FailureGroup group{same.status, same.code, part, "", *reasons.at(part.front())};
      for (std::size_t k = 0; k < study.axes.size(); ++k)
        group.where += (k == 0 ? "" : ", ") + Covered(study, k, group.points);
      groups.push_back(std::move(group));
    }
  }
  std::stable_sort(groups.begin(), groups.end(),
                   [](const auto& a, const auto& b) { return a.points.size() > b.points.size(); });
  return groups;
}

}  // namespace gaitwright
