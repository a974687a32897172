// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/exchange/missing_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "workflows/exchange/median_internal.h"

namespace gaitwright {
namespace {

/// The median step. @pre two rows or more.
double UsualStep(const std::vector<double>& time_s) {
  std::vector<double> steps;
  for (std::size_t k = 1; k < time_s.size(); ++k) steps.push_back(time_s[k] - time_s[k - 1]);
  return MedianOf(std::move(steps));
}

}  // namespace

double LongestStep(const std::vector<double>& time_s) {
  constexpr double kUsualSteps = 3.0, kLeast = 0.03;  // [1], [s]
  if (time_s.size() < 3) return std::numeric_limits<double>::infinity();
  return std::max(kUsualSteps * UsualStep(time_s), kLeast);
}

std::vector<TimeGap> GapsOf(const std::vector<double>& time_s, double longest_step_s) {
  std::vector<TimeGap> gaps;
  for (std::size_t k = 1; k < time_s.size(); ++k) {
    if (time_s[k] - time_s[k - 1] > longest_step_s) gaps.push_back({time_s[k - 1], time_s[k]});
  }
  return gaps;
}

bool InGap(const std::vector<TimeGap>& gaps, double at_s) {
  constexpr double kAtRow = 1e-6;  // [s]: resolution of a double that counts seconds from 1970
  const auto after = std::upper_bound(gaps.begin(), gaps.end(), at_s - kAtRow,
                                      [](double time_s, const TimeGap& gap) { return time_s < gap.start_s; });
  return after != gaps.begin() && at_s < std::prev(after)->end_s - kAtRow;
}

std::string MissingRowsText(const std::vector<double>& time_s) {
  const std::vector<TimeGap> gaps = GapsOf(time_s, LongestStep(time_s));
  if (gaps.empty()) return "";
  const auto shorter = [](const TimeGap& a, const TimeGap& b) { return a.end_s - a.start_s < b.end_s - b.start_s; };
  const TimeGap longest = *std::max_element(gaps.begin(), gaps.end(), shorter);
  return fmt::format(
      "rows are missing{}: no row for {:.3g} s after {:.6g} s of the file; rows are usually {:.3g} ms apart",
      gaps.size() == 1 ? "" : fmt::format(" in {} places, and this is the longest gap", gaps.size()),
      longest.end_s - longest.start_s, longest.start_s, 1e3 * UsualStep(time_s));
}

}  // namespace gaitwright
