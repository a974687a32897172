// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "kinematics/ik/leg_ik.h"
#include "optimisation/numerics/smooth_within.h"

namespace gaitwright {

/// Range of heights of the base at which all legs reach their feet.
class ReachHeight {
 public:
  /// @param model  must outlive this object.
  explicit ReachHeight(const RobotModel& model);

  /// The range of changes of the base's height [m], around the smallest possible change, for which every leg reaches
  /// its foot with joints within their limits; at most a quarter of the leg's length. Nothing if no change is possible.
  /// @param X_WF   controlled frames (middle of a sole, centre of a sphere) by foot.
  /// @param margin  margin to both ends, as a share of the leg's length, if the range is large enough.
  std::optional<Bounds> Changes(const Pose& X_WB, const std::vector<Pose>& X_WF, double margin) const;

 private:
  bool AllReach(Pose X_WB, double change_m, const std::vector<Pose>& X_WF, std::vector<VectorX>& near) const;
  std::optional<std::vector<VectorX>> Joints(const Pose& X_WB, const std::vector<Pose>& X_WF) const;

  const RobotModel& model_;
  std::vector<LegIk> legs_;
  std::vector<VectorX> standing_;  // joints of each leg
  double leg_m_;
};

}  // namespace gaitwright
