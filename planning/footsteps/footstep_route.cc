// SPDX-License-Identifier: BSD-3-Clause
#include "planning/footsteps/footstep_route.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "kinematics/base/result.h"
#include "kinematics/spatial/rotation.h"

namespace gaitwright {

PlanarPose RouteAt(const FootstepRoute& route, double station_m) {
  const auto after = std::upper_bound(route.station_m.begin(), route.station_m.end(), station_m);
  if (after == route.station_m.begin()) return route.pose.front();
  if (after == route.station_m.end()) return route.pose.back();
  const auto i = static_cast<std::size_t>(after - route.station_m.begin());
  const double u = (station_m - route.station_m[i - 1]) / (route.station_m[i] - route.station_m[i - 1]);
  const PlanarPose &a = route.pose[i - 1], &b = route.pose[i];
  return {a.x_m + u * (b.x_m - a.x_m), a.y_m + u * (b.y_m - a.y_m), a.yaw_rad + u * (b.yaw_rad - a.yaw_rad)};
}

FootstepRoute RouteAlong(const PlanarTwist& twist, double turn_radius_m) {
  constexpr double kStep = 0.05;  // [rad]
  const int parts = std::max(1, static_cast<int>(std::ceil(std::abs(twist.yaw_rad) / kStep)));
  const double length = std::max(std::hypot(twist.x_m, twist.y_m), turn_radius_m * std::abs(twist.yaw_rad));
  FootstepRoute route;
  for (int k = 0; k <= parts; ++k) {
    const double progress = static_cast<double>(k) / parts;
    route.pose.push_back(PoseAlong(twist, progress));
    route.station_m.push_back(progress * length);
  }
  return route;
}

FootstepRoute RouteThrough(const std::vector<PlanarPose>& poses, const RouteSpeeds& speeds) {
  if (poses.empty()) throw InvalidArgument("RouteThrough: there is no pose; one or more are needed");
  for (const double speed : {speeds.forward_m_s, speeds.lateral_m_s, speeds.turn_rad_s}) {
    if (!(speed > 0.0)) throw InvalidArgument(fmt::format("RouteThrough: a speed is {}; it must be positive", speed));
  }
  FootstepRoute route{{poses.front()}, {0.0}};
  for (const PlanarPose& next : poses) {
    if (!std::isfinite(next.x_m + next.y_m + next.yaw_rad)) throw InvalidArgument("RouteThrough: a pose is not finite");
    const PlanarPose& last = route.pose.back();
    const double turn = WrapAngle(next.yaw_rad - last.yaw_rad), heading = last.yaw_rad + 0.5 * turn;
    const double dx = next.x_m - last.x_m, dy = next.y_m - last.y_m;
    const double c = std::cos(heading), s = std::sin(heading);
    const double time = std::max({std::abs(c * dx + s * dy) / speeds.forward_m_s,
                                  std::abs(c * dy - s * dx) / speeds.lateral_m_s, std::abs(turn) / speeds.turn_rad_s});
    if (time <= 0.0) continue;
    route.station_m.push_back(route.station_m.back() + speeds.forward_m_s * time);
    route.pose.push_back({next.x_m, next.y_m, last.yaw_rad + turn});
  }
  return route;
}

}  // namespace gaitwright
