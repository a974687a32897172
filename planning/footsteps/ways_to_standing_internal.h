// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "planning/footsteps/base_over_feet.h"

namespace gaitwright {

/// The standing posture that is nearest to a posture on level ground, and how far the feet are beside it.
struct WaysToStanding {
  BaseOverFeet base;  ///< of the standing posture
  /// By leg: what its foot is beside the place from which it rolls to its place in standing, if the robot goes to the
  /// standing posture with its feet on the ground [m], horizontal.
  std::vector<Vector3> way_W;

  double largest_m() const;
};

/// @param yaw_rad  heading of the base in standing; if not given, the one that fits the feet best.
WaysToStanding FindWaysToStanding(const RobotModel& model, const VectorX& q, std::optional<double> yaw_rad = {});

}  // namespace gaitwright
