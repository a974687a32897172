// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "workflows/study/sweep.h"

namespace gaitwright {

/// The map as CSV, one row per point in order: point, each axis by its key, status, code, score, each metric by its
/// key, fell_at_s; with two engines the verdict and score of each, by its name (bullet_verdict, bullet_score); with
/// trials their number, survived, survival, survival_low, survival_high and trial_score_mean; last the reason. Cells
/// without a value are empty.
std::string SweepCsv(const Study& study, const std::vector<PointOutcome>& outcomes);

/// Written files: kind and path.
using WrittenFiles = std::vector<std::pair<std::string, std::string>>;

/// The object of `sweep --json`, see docs/json-output.md.
std::string SweepJson(const Study& study, const std::vector<PointOutcome>& outcomes, const WrittenFiles& files);

/// Playback options of a point, which its plan does not contain: "--set KEY=VALUE ..." for `play`, or "".
std::string PlayFlags(const Study& study, std::size_t point);

/// "10 points pass in both, 1 only in Bullet, 0 only in MuJoCo, 2 in neither"; empty for one engine.
std::string EnginesText(const std::vector<PointOutcome>& outcomes);

/// The sweep as text: counts, the best point, and the failures with their reasons.
std::string SweepText(const Study& study, const std::vector<PointOutcome>& outcomes);

}  // namespace gaitwright
