// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "optimisation/centroidal/rigid_body_problem.h"
#include "planning/plan/terrain.h"

namespace gaitwright {

/// From start to goal on a straight line in plan view, evenly from the first lift-off to the last touch-down, as high
/// over the ground below the feet as they like to stand; level.
BodyWay StraightWay(const Terrain& terrain, const RigidBodyProblem& problem, double spacing_s);

/// Moves the way and the footholds that are not held so that feet are within reach, near to where they like to stand,
/// and the way is smooth: the least of
///   sum_k (|p''_k| / 20 m/s^2)^2 + (|angles''_k| / 60 rad/s^2)^2 + (0.3 m |angles_k - wanted|)^2
///   + sum of squares of what misses where feet like to stand, and of 30 times what is out of reach.
/// Footholds stay on their patches' planes, and in their regions.
void FitBodyWay(RigidBodyProblem& problem, BodyWay& way);

/// Where a stance's foot would like to stand on the whole of its time [m].
Vector3 WantedFoothold(const RigidBodyProblem& problem, const BodyWay& way, std::size_t stance);

/// What makes one foothold worse than another on a way: the sum that FitBodyWay makes small, over this stance.
double StanceMisfit(const RigidBodyProblem& problem, const BodyWay& way, std::size_t stance);

/// Farthest that a stance's foot is out of its workspace, wherever it stands in its region, from a body that is where
/// it is [m].
double LeastOutOfReach(const RigidBodyProblem& problem, std::size_t stance, const RigidBodyState& body);

/// The foot of a stance.
const RigidFoot& FootOf(const RigidBodyProblem& problem, std::size_t stance);

/// How far feet are out of reach on a way.
struct BodyWayMisfit {
  double largest_m = 0.0, at_s = 0.0;
  double sum = 0.0;  ///< of squares, over times and sides [m^2]
  int stance = -1;   ///< that is farthest out; -1 where all are within reach
};

/// Of one stance's foot, and of all.
BodyWayMisfit OutOfReach(const RigidBodyProblem& problem, const BodyWay& way, std::size_t stance);
BodyWayMisfit OutOfReach(const RigidBodyProblem& problem, const BodyWay& way);

}  // namespace gaitwright
