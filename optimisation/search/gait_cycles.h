// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "optimisation/search/plan_walk.h"

namespace gaitwright {

/// A gait fitted to a command and its other possible cycles by index: 0 as fitted, up to kShortest ever shorter, down
/// to kLongest ever longer, in equal ratios.
struct GaitCycles {
  /// Neighbouring cycles differ by about 10 %; plans for cycles in between hardly differ.
  static constexpr int kShortest = 6, kLongest = -4;
  Gait fitted;
  double shortest_s = 0.0, longest_s = 0.0;
  double step_s = 0.0;  ///< each cycle is a multiple of this time; 0 for any cycle

  /// The gait with the cycle of an index from kLongest to kShortest.
  Gait At(int number) const;
};

/// Failure as for FindGait.
Result<GaitCycles> FindCycles(const RobotModel& model, const WalkRequest& request, const WalkCommand& command);

}  // namespace gaitwright
