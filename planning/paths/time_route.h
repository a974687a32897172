// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// Speeds and times for following a route.
struct RouteTiming {
  double speed_m_s = 0.0;          ///< largest speed, forward and backward; > 0
  double lateral_speed_m_s = 0.0;  ///< largest lateral speed; > 0
  double yaw_rate_rad_s = 0.0;     ///< largest yaw rate; > 0
  double ramp_s = 0.5;             ///< time to reach full speed or to stop; 0 for jumps of speed
  double start_s = 0.0;            ///< departure of the base; it stands before
  double end_s = 0.0;              ///< if the path ends sooner, the base rests until then
};

/// The base path that follows waypoints within the given speeds, sampled every 10 ms where it moves. It starts and ends
/// at rest and accelerates smoothly. It slows down where the direction of motion changes, so that the change is at most
/// 30 % of the full speeds. It stays on the route, which is linear between the waypoints.
/// @throws InvalidArgument if there are no waypoints, or a speed is not > 0.
BasePath TimeRoute(const std::vector<PlanarPose>& waypoints, const RouteTiming& timing);

/// Time to follow the waypoints, from departure to rest [s].
double RouteDuration(const std::vector<PlanarPose>& waypoints, const RouteTiming& timing);

}  // namespace gaitwright
