// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "planning/footsteps/course.h"
#include "planning/paths/base_path.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// The planar path of the base by station: a length along the path that grows from 0 with the time at full speed.
struct FootstepRoute {
  std::vector<PlanarPose> pose;
  std::vector<double> station_m;  ///< same number of values, ascending from 0

  double length_m() const { return station_m.empty() ? 0.0 : station_m.back(); }
};

/// The pose at a station, with linear interpolation; clamped at the ends.
PlanarPose RouteAt(const FootstepRoute& route, double station_m);

/// The route along a twist. Its length is that of the path in plan view, or `turn_radius_m` times its yaw if that is
/// longer.
FootstepRoute RouteAlong(const PlanarTwist& twist, double turn_radius_m);

/// Full speeds along a route: forward, lateral and turning; all positive.
struct RouteSpeeds {
  double forward_m_s = 1.0, lateral_m_s = 1.0, turn_rad_s = 1.0;
};

/// The route through poses. Stations grow by the forward speed times the longest of the times for the forward, lateral
/// and turning motion. Yaws are unwrapped. @throws InvalidArgument without a pose, for poses that are not finite, and
/// for a speed that is not positive.
FootstepRoute RouteThrough(const std::vector<PlanarPose>& poses, const RouteSpeeds& speeds);

}  // namespace gaitwright
