// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/base/options.h"

namespace gaitwright {

/// Bounds and steps of the optimisation of contact times (OptimiseTiming).
///
/// Tuning
///   phases of the gait become very short or long    raise shortest_s, lower longest_s
///   legs cannot swing fast enough                   raise shortest_swing_s
///   the total time should change more               raise most_total, lower least_total
///   the cost could fall further                     lower least_gain, raise max_solves
///   motions between steps of the search are refused lower first_change, most_change
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

  /// Options of the phases, which also apply to whole robots.
  OptionFields PhaseFields();
  /// All options.
  OptionFields Fields();
};

}  // namespace gaitwright
