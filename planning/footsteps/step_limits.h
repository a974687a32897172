// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "planning/footsteps/search_footsteps.h"

namespace gaitwright {

/// Limits of a robot with a gait, a stride and options, found by trial on synthetic ground. Used in messages. Accurate
/// to 1 % of the leg length.
class StepLimits {
 public:
  /// @param heading_rad  heading of the path, relative to the body.
  StepLimits(const RobotModel& model, const FootstepQuery& query, const FootholdOptions& footholds,
             const FootstepSearchOptions& options, double heading_rad);

  /// The widest gap that the robot can cross, at most `most_m` [m].
  double WidestGap(double most_m) const;
  /// The highest step up or down that the robot can take, at most `most_m` [m].
  double HighestStep(double most_m, bool up) const;

 private:
  bool Passes(double gap_m, double rise_m) const;
  template <class Test>
  double Largest(double most_m, const Test& passes) const;

  const RobotModel* model_;
  FootstepQuery query_;
  FootholdOptions footholds_;
  FootstepSearchOptions options_;
  double heading_rad_;
  double spread_m_ = 0.0;  // spread of the feet around the base, plus half a leg length
};

}  // namespace gaitwright
