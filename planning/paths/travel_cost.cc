// SPDX-License-Identifier: BSD-3-Clause
#include "planning/paths/travel_cost.h"

#include <cmath>

#include "kinematics/spatial/rotation.h"

namespace gaitwright {
namespace {

/// Cost per unit of progress at a heading, for a step (dx, dy, turn) in W.
double Rate(const Vector2& step, double turn, double yaw, const TravelWeights& weights) {
  const double c = std::cos(yaw), s = std::sin(yaw);
  const double forward = c * step.x() + s * step.y(), lateral = weights.lateral * (c * step.y() - s * step.x());
  const double along = forward < 0.0 ? weights.backward * forward : forward, turned = weights.turn_m_rad * turn;
  return std::sqrt(along * along + lateral * lateral + turned * turned);
}

}  // namespace

double TravelCost(const PlanarPose& a, const PlanarPose& b, const TravelWeights& weights) {
  constexpr double kMostTurn = 0.5;  // [rad] largest turn in one interval
  const Vector2 step(b.x_m - a.x_m, b.y_m - a.y_m);
  const double turn = b.yaw_rad - a.yaw_rad;
  const int intervals = 1 + static_cast<int>(std::abs(turn) / kMostTurn);
  double sum = 0.0;
  for (int k = 0; k <= 2 * intervals; ++k) {
    const double weight = k == 0 || k == 2 * intervals ? 1.0 : (k % 2 == 1 ? 4.0 : 2.0);
    sum += weight * Rate(step, turn, a.yaw_rad + turn * k / (2.0 * intervals), weights);
  }
  return sum / (6.0 * intervals);
}

double TravelCost(const std::vector<PlanarPose>& path, const TravelWeights& weights) {
  double cost = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i) cost += TravelCost(path[i - 1], path[i], weights);
  return cost;
}

double LengthOf(const std::vector<PlanarPose>& path) {
  double length = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i)
    length += std::hypot(path[i].x_m - path[i - 1].x_m, path[i].y_m - path[i - 1].y_m);
  return length;
}

double UnwrappedNear(double angle_rad, double near_rad) { return near_rad + WrapAngle(angle_rad - near_rad); }

}  // namespace gaitwright
