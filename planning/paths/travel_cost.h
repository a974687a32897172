// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// Cost of a metre in each direction of the body; forward motion costs 1.
struct TravelWeights {
  double lateral = 2.5;
  double backward = 1.5;
  double turn_m_rad = 0.25;  ///< cost of a radian of turning, in metres of forward motion
};

/// Cost of a straight motion from a to b with constant yaw rate, in metres of forward motion:
///   integral of sqrt((w v_x)^2 + (lateral v_y)^2 + (turn_m_rad yaw')^2),
/// v is in the body's frame; w is 1 forward and `backward` backward. Simpson's rule over intervals of at most half a
/// radian. Not less than the distance. Yaws are not wrapped.
double TravelCost(const PlanarPose& a, const PlanarPose& b, const TravelWeights& weights);

/// Cost of a path, summed along waypoints.
double TravelCost(const std::vector<PlanarPose>& path, const TravelWeights& weights);

/// Length of a path in plan view [m].
double LengthOf(const std::vector<PlanarPose>& path);

/// The pose at a share u of the straight path from a to b with constant yaw rate; yaws are not wrapped.
inline PlanarPose Between(const PlanarPose& a, const PlanarPose& b, double u) {
  return {a.x_m + u * (b.x_m - a.x_m), a.y_m + u * (b.y_m - a.y_m), a.yaw_rad + u * (b.yaw_rad - a.yaw_rad)};
}

/// `angle_rad` plus the multiple of 2 pi that brings it nearest to `near_rad`.
double UnwrappedNear(double angle_rad, double near_rad);

}  // namespace gaitwright
