// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "planning/footsteps/course.h"
#include "planning/paths/base_path.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// The path of the base in plan view, by station: a length along it that grows from 0 with time at full speed.
struct FootstepRoute {
  std::vector<PlanarPose> pose;
  std::vector<double> station_m;  ///< as many, rising from 0

  double length_m() const { return station_m.empty() ? 0.0 : station_m.back(); }
};

/// The pose at a station, linearly between those given and clamped at the ends.
PlanarPose RouteAt(const FootstepRoute& route, double station_m);

/// The route along a twist. Its length is that of the path in plan view, or `turn_radius_m` times its yaw if that is
/// longer.
FootstepRoute RouteAlong(const PlanarTwist& twist, double turn_radius_m);

/// Speeds that a route is gone at: along and across the body, and turning; all positive.
struct RouteSpeeds {
  double ahead_m_s = 1.0, lateral_m_s = 1.0, turn_rad_s = 1.0;
};

/// The route through poses: stations grow by speed ahead times the time that the slowest of ahead, lateral and turning
/// takes. Yaws are unwrapped. @throws InvalidArgument without a pose, with poses that are not finite or a speed that is
/// not positive.
FootstepRoute RouteThrough(const std::vector<PlanarPose>& poses, const RouteSpeeds& speeds);

}  // namespace gaitwright
