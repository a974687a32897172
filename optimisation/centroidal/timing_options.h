// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/base/options.h"

namespace gaitwright {

/// How the times of contacts may be changed (OptimiseTiming).
///
/// Tuning
///   phases of the gait become a hurry or a wait     raise shortest_s, lower longest_s
///   legs cannot swing as fast as that               raise shortest_swing_s
///   there is no haste, or time to gain              raise most_total, lower least_total
///   cost could fall further                         lower least_gain, raise max_solves
///   motions from one step to the next are refused   lower first_change, most_change
struct TimingOptions {
  double shortest_s = 0.02;
  double longest_s = 5.0;
  double shortest_swing_s = 0.15;
  double least_total = 1.0;
  double most_total = 1.0;
  double first_change = 0.2;
  double most_change = 0.5;
  double least_gain = 1e-2;
  int max_solves = 12;

  /// Those of the phases, which hold for whole robots too.
  OptionFields PhaseFields();
  /// All.
  OptionFields Fields();
};

}  // namespace gaitwright
