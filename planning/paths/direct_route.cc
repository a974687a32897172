// SPDX-License-Identifier: BSD-3-Clause
#include "planning/paths/direct_route.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "kinematics/spatial/rotation.h"
#include "planning/paths/base_path.h"

namespace gaitwright {
namespace {

PlanarPose After(const PlanarPose& a, const PlanarPose& step) {
  const double c = std::cos(a.yaw_rad), s = std::sin(a.yaw_rad);
  return {a.x_m + c * step.x_m - s * step.y_m, a.y_m + s * step.x_m + c * step.y_m, a.yaw_rad + step.yaw_rad};
}

/// Pose b in the frame of a.
PlanarPose SeenFrom(const PlanarPose& a, const PlanarPose& b) {
  const double c = std::cos(a.yaw_rad), s = std::sin(a.yaw_rad), dx = b.x_m - a.x_m, dy = b.y_m - a.y_m;
  return {c * dx + s * dy, c * dy - s * dx, b.yaw_rad - a.yaw_rad};
}

std::vector<PlanarPose> Arc(const PlanarPose& a, const PlanarPose& b, const Spacing& spacing) {
  const PlanarTwist twist = TwistTo(SeenFrom(a, b));
  const double parts =
      std::max(std::hypot(twist.x_m, twist.y_m) / spacing.distance_m, std::abs(twist.yaw_rad) / spacing.turn_rad);
  const int n = std::max(1, static_cast<int>(std::ceil(parts - 1e-9)));
  std::vector<PlanarPose> poses = {a};
  for (int k = 1; k < n; ++k) poses.push_back(After(a, PoseAlong(twist, static_cast<double>(k) / n)));
  poses.push_back(b);
  return poses;
}

/// Corners of a direct path that consists of straight lines.
std::vector<PlanarPose> CornersOf(DirectRoute kind, const PlanarPose& a, const PlanarPose& b) {
  PlanarPose end = b;
  end.yaw_rad = UnwrappedNear(b.yaw_rad, a.yaw_rad);
  if (kind == DirectRoute::kStraight) return {a, end};
  double heading = std::atan2(b.y_m - a.y_m, b.x_m - a.x_m);
  if (kind == DirectRoute::kBackward) heading += std::numbers::pi;
  heading = UnwrappedNear(heading, a.yaw_rad);
  end.yaw_rad = UnwrappedNear(b.yaw_rad, heading);
  return {a, {a.x_m, a.y_m, heading}, {b.x_m, b.y_m, heading}, end};
}

}  // namespace

std::vector<PlanarPose> Densified(const std::vector<PlanarPose>& path, const Spacing& spacing) {
  std::vector<PlanarPose> dense;
  if (!path.empty()) dense.push_back(path.front());
  for (std::size_t i = 1; i < path.size(); ++i) {
    const PlanarPose &a = path[i - 1], &b = path[i];
    const double length = std::hypot(b.x_m - a.x_m, b.y_m - a.y_m), turn = std::abs(b.yaw_rad - a.yaw_rad);
    const int n = static_cast<int>(std::ceil(std::max(length / spacing.distance_m, turn / spacing.turn_rad) - 1e-9));
    for (int k = 1; k < n; ++k) dense.push_back(Between(a, b, static_cast<double>(k) / n));
    if (n > 0) dense.push_back(b);
  }
  return dense;
}

std::vector<PlanarPose> WaypointsOf(DirectRoute kind, const PlanarPose& a, const PlanarPose& b,
                                    const Spacing& spacing) {
  if (kind != DirectRoute::kTwist) return Densified(CornersOf(kind, a, b), spacing);
  return Arc(a, {b.x_m, b.y_m, UnwrappedNear(b.yaw_rad, a.yaw_rad)}, spacing);
}

double CostOf(DirectRoute kind, const PlanarPose& a, const PlanarPose& b, const TravelWeights& weights) {
  if (kind != DirectRoute::kTwist) {
    const std::vector<PlanarPose> corners = CornersOf(kind, a, b);
    return TravelCost(corners, weights);
  }
  const PlanarTwist twist = TwistTo(SeenFrom(a, {b.x_m, b.y_m, UnwrappedNear(b.yaw_rad, a.yaw_rad)}));
  const double along = twist.x_m < 0.0 ? weights.backward * twist.x_m : twist.x_m;
  return std::hypot(along, weights.lateral * twist.y_m, weights.turn_m_rad * twist.yaw_rad);
}

std::vector<std::pair<double, DirectRoute>> ByCost(const PlanarPose& a, const PlanarPose& b,
                                                   const TravelWeights& weights) {
  std::vector<std::pair<double, DirectRoute>> routes;
  for (const DirectRoute kind : kDirectRoutes) routes.emplace_back(CostOf(kind, a, b, weights), kind);
  std::sort(routes.begin(), routes.end());
  return routes;
}

}  // namespace gaitwright
