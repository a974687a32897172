// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/search/pace_search.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace gaitwright {
namespace {

/// The numbers of two significant digits between two others, which are excluded.
std::vector<double> TwoDigitsBetween(double low, double high) {
  std::vector<double> values;
  const double decade = std::floor(std::log10(low) + 1e-12);
  for (double power : {std::pow(10.0, decade), std::pow(10.0, decade + 1.0)}) {
    for (int tenth = 10; tenth < 100; ++tenth) {
      const double value = TowardsZero(0.1 * tenth * power, 2);
      if (value > low * (1.0 + 1e-9) && value < high * (1.0 - 1e-9)) values.push_back(value);
    }
  }
  return values;
}

/// Largest possible number of two significant digits between `known` and `high`, or `known` if none is possible. By
/// bisection.
double LargestBetween(double known, double high, const std::function<bool(double)>& possible) {
  const std::vector<double> between = TwoDigitsBetween(known, high);
  const auto first_impossible =
      std::partition_point(between.begin(), between.end(), [&](double value) { return possible(value); });
  return first_impossible == between.begin() ? known : *(first_impossible - 1);
}

}  // namespace

double TowardsZero(double value, int digits) {
  if (value == 0.0) return 0.0;
  const double unit = std::pow(10.0, std::floor(std::log10(std::abs(value)) + 1e-12) - digits + 1);
  const double rounded = std::trunc(value / unit + std::copysign(1e-6, value));
  return std::stod(fmt::format("{:.{}g}", rounded * unit, digits));
}

double NextLower(double value) { return TwoDigitsBetween(0.5 * value, value).back(); }

double SomePace(const PaceRange& range, const std::function<bool(double)>& possible) {
  double pace = TowardsZero(std::min(0.5 * range.asked, range.unreachable), 2);
  if (!possible(TowardsZero(std::ldexp(pace, -range.halvings), 2))) return 0.0;
  for (int halvings = 0; halvings < range.halvings; ++halvings) {
    if (possible(pace)) return pace;
    pace = TowardsZero(0.5 * pace, 2);
  }
  return 0.0;
}

double LargestPace(const PaceRange& range, const std::function<bool(double)>& possible) {
  double high = range.asked;
  const auto noted = [&](double pace) {
    const bool is_possible = possible(pace);
    if (!is_possible) high = pace;
    return is_possible;
  };
  const double low = SomePace(range, noted);
  return low == 0.0 ? 0.0 : LargestBetween(low, high, possible);
}

double LargestPaceAbove(const PaceRange& range, double known, int grain, const std::function<bool(double)>& possible) {
  const std::vector<double> between = TwoDigitsBetween(known, range.asked);
  const auto least = static_cast<std::size_t>(grain);
  std::size_t below = 0, end = between.size(), stride = 1;  // possible before `below`, impossible from `end` on
  while (end - below >= (below == 0 ? 1 : least)) {
    const std::size_t next = std::min(below + stride - 1, (below + end) / 2);
    const bool is_possible = possible(between[next]);
    stride = is_possible ? 2 * stride : between.size();
    (is_possible ? below : end) = is_possible ? next + 1 : next;
  }
  return below == 0 ? known : between[below - 1];
}

}  // namespace gaitwright
