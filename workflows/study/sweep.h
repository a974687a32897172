// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "workflows/study/run_point.h"

namespace gaitwright {

/// What a sweep came to. A pure function of its outcomes, so that these may have been made anywhere, in any order.
struct SweepSummary {
  std::array<int, std::size(kPointStatuses)> counts = {};  ///< by PointStatus
  std::optional<std::size_t> best;  ///< the point that IsBetter prefers, of those whose plan passes its audit

  /// How many points came to that.
  int Count(PointStatus status) const { return counts[static_cast<std::size_t>(status)]; }
};

/// Counts outcomes and finds the best.
SweepSummary SummaryOf(const std::vector<PointOutcome>& outcomes);

/// Points that failed in one way and lie together: where, and an example of why.
struct FailureGroup {
  PointStatus status = PointStatus::kRefused;
  std::string code;
  std::vector<std::size_t> points;
  std::string where;    ///< the range of each axis that they cover: "speed 0.9 to 1.2 m/s, gait.cycle_s 0.5 to 0.8 s"
  std::string example;  ///< the reason of the first of them
};

/// All points that did not pass, by status and code and then by where they are: in ranges without a point that came to
/// something else, as far as a few ranges do. The largest group first.
std::vector<FailureGroup> FailureGroups(const Study& study, const std::vector<PointOutcome>& outcomes);

}  // namespace gaitwright
