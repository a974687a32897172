// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "workflows/study/run_point.h"

namespace gaitwright {

/// Summary of a sweep: a pure function of its outcomes, which may have been computed anywhere, in any order.
struct SweepSummary {
  std::array<int, std::size(kPointStatuses)> counts = {};  ///< by PointStatus
  std::optional<std::size_t> best;  ///< best point by IsBetter, among those whose plan passes its audit

  /// Number of points with a status.
  int Count(PointStatus status) const { return counts[static_cast<std::size_t>(status)]; }
};

/// How two engines judge the points that both have played; all zero for one engine.
struct EngineCounts {
  std::string first, second;  ///< their names
  int both_pass = 0, none_pass = 0, first_alone = 0, second_alone = 0;

  int points() const { return both_pass + none_pass + first_alone + second_alone; }
};
/// Counts the points that were played in two engines.
EngineCounts CountEngines(const std::vector<PointOutcome>& outcomes);

/// Counts outcomes and finds the best.
SweepSummary SummaryOf(const std::vector<PointOutcome>& outcomes);

/// A group of neighbouring points with the same failure: their ranges and an example of the reason.
struct FailureGroup {
  PointStatus status = PointStatus::kRefused;
  std::string code;
  std::vector<std::size_t> points;
  std::string where;    ///< the range of each axis that they cover: "speed 0.9 to 1.2 m/s, gait.cycle_s 0.5 to 0.8 s"
  std::string example;  ///< reason of the first point
};

/// All points that did not pass, grouped by status and code and then by location, in ranges without points of another
/// status as far as a few ranges allow. The largest group is first.
std::vector<FailureGroup> FailureGroups(const Study& study, const std::vector<PointOutcome>& outcomes);

}  // namespace gaitwright
