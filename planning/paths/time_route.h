// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// How fast a route is followed.
struct RouteTiming {
  double speed_m_s = 0.0;          ///< largest, forward and backward; > 0
  double lateral_speed_m_s = 0.0;  ///< most; > 0
  double yaw_rate_rad_s = 0.0;     ///< most; > 0
  double ramp_s = 0.5;             ///< in which the full speed is gained or lost; 0 for at once
  double start_s = 0.0;            ///< when the base sets off; it stands before
  double end_s = 0.0;              ///< the path goes on at rest until then, if it ends sooner
};

/// The base path that follows waypoints at no more than the speeds given, sampled every 10 ms where it moves. It starts
/// and ends at rest, gains and loses speed smoothly, and slows where the motion of the body changes its direction: to
/// where a change would be no more than three tenths of the full speeds. It stays on the route, which is linear between
/// the waypoints.
/// @throws InvalidArgument when there are no waypoints, or a speed is not > 0.
BasePath TimeRoute(const std::vector<PlanarPose>& waypoints, const RouteTiming& timing);

/// How long following them takes, from setting off to standing [s].
double RouteDuration(const std::vector<PlanarPose>& waypoints, const RouteTiming& timing);

}  // namespace gaitwright
