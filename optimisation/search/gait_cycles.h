// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "optimisation/search/plan_walk.h"

namespace gaitwright {

/// A gait fitted to a command and its other possible cycles, by number: 0 as fitted, up to kQuickest ever shorter, down
/// to kSlowest ever longer, in even ratios.
struct GaitCycles {
  /// Neighbours differ by a tenth or so, within which plans hardly differ.
  static constexpr int kQuickest = 6, kSlowest = -4;
  Gait fitted;
  double shortest_s = 0.0, longest_s = 0.0;
  double step_s = 0.0;  ///< each is a whole number of these; 0 for any

  /// The gait with the cycle of that number, from kSlowest to kQuickest.
  Gait At(int number) const;
};

/// Failure as of FindGait.
Result<GaitCycles> FindCycles(const RobotModel& model, const WalkRequest& request, const WalkCommand& command);

}  // namespace gaitwright
