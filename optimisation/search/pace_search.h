// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

namespace gaitwright {

/// The paces among which a search looks for the largest that is possible, each of two digits.
struct PaceRange {
  double asked = 0.0;      ///< the paces looked at are below it
  double unreachable = 0;  ///< no pace from here on is possible
  int halvings = 9;        ///< how often the first pace is halved at most
};

/// Rounded towards zero to a number of significant digits.
double TowardsZero(double value, int digits);

/// The next lower number of two digits.
double NextLower(double value);

/// Largest pace of the range that is possible: by halving and then bisection, at most 20 questions. 0 when there is
/// none, as when the slowest is not possible.
double LargestPace(const PaceRange& range, const std::function<bool(double)>& possible);

/// The same from a pace on that is known to be possible, short of the largest by less than `grain` numbers of two
/// digits; that one when none above it is, as one question tells. Strides up from it double, and where they lead too
/// far they are bisected.
double LargestPaceAbove(const PaceRange& range, double known, int grain, const std::function<bool(double)>& possible);

}  // namespace gaitwright
