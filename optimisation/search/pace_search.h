// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

namespace gaitwright {

/// The speeds among which the largest possible one is searched; each has two significant digits.
struct PaceRange {
  double asked = 0.0;      ///< only lower speeds are evaluated
  double unreachable = 0;  ///< this speed and all higher ones are impossible
  int halvings = 9;        ///< largest number of halvings of the first speed
};

/// Rounds towards zero to a number of significant digits.
double TowardsZero(double value, int digits);

/// The next lower number of two significant digits.
double NextLower(double value);

/// The first possible speed of the range among halves of the requested one; 0 if there is none, which is assumed if the
/// slowest one is not possible.
double SomePace(const PaceRange& range, const std::function<bool(double)>& possible);

/// Largest possible speed of the range, by halving and then bisection, with at most 20 evaluations. 0 if no speed is
/// possible; this is assumed if the slowest one is not.
double LargestPace(const PaceRange& range, const std::function<bool(double)>& possible);

/// Largest possible speed of the range, starting from a speed that is known to be possible. The result may be less than
/// the largest one by less than `grain` numbers of two significant digits. One evaluation tells that no higher speed is
/// possible; then it is `known`. Strides upward double; the last one is bisected.
double LargestPaceAbove(const PaceRange& range, double known, int grain, const std::function<bool(double)>& possible);

}  // namespace gaitwright
