// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "workflows/study/sweep.h"

namespace gaitwright {

/// The map as CSV, a row a point in their order: point, each axis by its key, status, code, score, each metric by its
/// key, fell_at_s, and with trials their number, survived, survival, survival_low, survival_high and
/// trial_score_mean; last the reason. Cells without a value are empty.
std::string SweepCsv(const Study& study, const std::vector<PointOutcome>& outcomes);

/// What was written: kind and path.
using WrittenFiles = std::vector<std::pair<std::string, std::string>>;

/// The object of `sweep --json`, see docs/json-output.md.
std::string SweepJson(const Study& study, const std::vector<PointOutcome>& outcomes, const WrittenFiles& files);

/// What of a point its plan does not hold, since it is of the playback: "--set KEY=VALUE ..." for `play`, or "".
std::string PlayFlags(const Study& study, std::size_t point);

/// The sweep in words: counts, the best point, where it fails and why.
std::string SweepText(const Study& study, const std::vector<PointOutcome>& outcomes);

}  // namespace gaitwright
