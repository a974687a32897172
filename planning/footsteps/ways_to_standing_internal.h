// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "planning/footsteps/base_over_feet.h"

namespace gaitwright {

/// The standing posture that is nearest to a posture on level ground, and how far the feet are beside it.
struct OffsetsToStanding {
  BaseOverFeet base;  ///< of the standing posture
  /// By leg: horizontal offset of the foot's standing place from where the foot arrives by rolling, if the robot goes
  /// to the standing posture with its feet on the ground [m].
  std::vector<Vector3> offset_W;

  double largest_m() const;
};

/// @param yaw_rad  heading of the base in standing; if not given, the one that fits the feet best.
OffsetsToStanding FindOffsetsToStanding(const RobotModel& model, const VectorX& q, std::optional<double> yaw_rad = {});

}  // namespace gaitwright
