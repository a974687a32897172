// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace gaitwright {

/// A time interval between two rows of a motion in which rows are missing [s].
struct TimeGap {
  double start_s = 0.0, end_s = 0.0;
};

/// The longest step between two rows that does not count as missing rows: three times the median step, and at least 30
/// ms. Infinite for fewer than three rows.
double LongestStep(const std::vector<double>& time_s);

/// Gaps between rows that are farther apart than `longest_step_s`, in order.
std::vector<TimeGap> GapsOf(const std::vector<double>& time_s, double longest_step_s);

/// Whether a time is in one of the gaps, which must be in order without overlap. Rows at the ends of gaps are outside.
bool InGap(const std::vector<TimeGap>& gaps, double at_s);

/// "rows are missing: there are none for 1 s from the file's 0.8 s on; rows are usually 5 ms apart". For several gaps,
/// the text gives their number and the longest one. Empty if there are none.
std::string MissingRowsText(const std::vector<double>& time_s);

}  // namespace gaitwright
