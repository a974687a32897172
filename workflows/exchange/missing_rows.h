// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace gaitwright {

/// A time between two rows of a motion in which others are missing [s].
struct TimeGap {
  double start_s = 0.0, end_s = 0.0;
};

/// The longest step from row to row within which none is missing: three times the usual one, which is their median,
/// and at least 30 ms. Infinite for fewer than three rows.
double LongestStep(const std::vector<double>& time_s);

/// Gaps between rows that are farther apart than `longest_step_s`, in order.
std::vector<TimeGap> GapsOf(const std::vector<double>& time_s, double longest_step_s);

/// Whether a time is in one of the gaps, which are in order and do not overlap; rows at their ends are in none.
bool InGap(const std::vector<TimeGap>& gaps, double at_s);

/// "rows are missing: for 1 s from the file's 0.8 s on there is none, where they usually come every 5 ms"; of several
/// gaps their number, and the longest. Empty for none.
std::string MissingRowsText(const std::vector<double>& time_s);

}  // namespace gaitwright
