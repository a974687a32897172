// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "kinematics/ik/leg_ik.h"
#include "optimisation/numerics/smooth_within.h"

namespace gaitwright {

/// How high a base may be for all legs to reach their feet.
class ReachHeight {
 public:
  /// @param model  outlives this.
  explicit ReachHeight(const RobotModel& model);

  /// The changes of the base's height [m], about the least one, with which every leg brings its foot there, joints
  /// within their limits; up to a quarter of the leg's length. Nothing where there are none.
  /// @param X_WF   controlled frames (middle of a sole, centre of a sphere) by foot.
  /// @param spare  share of the leg's length that is kept to both ends, where there is as much room.
  std::optional<Bounds> Changes(const Pose& X_WB, const std::vector<Pose>& X_WF, double spare) const;

 private:
  bool AllReach(Pose X_WB, double change_m, const std::vector<Pose>& X_WF) const;

  const RobotModel& model_;
  std::vector<LegIk> legs_;
  double leg_m_;
};

}  // namespace gaitwright
