// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// A position past its joint's limits.
struct PastLimit {
  int row = 0, dof = 0;

  bool operator==(const PastLimit&) const = default;
};

/// Whether positions that are given as radians likely are in degrees: some joint that turns is more than 0.5 rad past
/// its limits, and all that turn would be within theirs, to 0.1 rad, as degrees. Then the one that is farthest past.
/// @param rows  positions of the independent joints [rad], [m]; what is no number is passed over.
std::optional<PastLimit> LikelyDegrees(const RobotModel& model, const std::vector<VectorX>& rows);

}  // namespace gaitwright
