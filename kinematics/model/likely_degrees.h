// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// A position outside the limits of its joint.
struct PastLimit {
  int row = 0, dof = 0;

  bool operator==(const PastLimit&) const = default;
};

/// Whether positions given in radians are probably in degrees: a revolute joint is more than 0.5 rad beyond its limits,
/// and as degrees all revolute joints would be within their limits, to 0.1 rad. Returns the joint that is farthest
/// beyond its limit.
/// @param rows  positions of the independent joints [rad], [m]; values that are not numbers are ignored.
std::optional<PastLimit> LikelyDegrees(const RobotModel& model, const std::vector<VectorX>& rows);

}  // namespace gaitwright
