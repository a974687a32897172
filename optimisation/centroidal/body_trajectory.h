// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "optimisation/centroidal/rigid_body_problem.h"
#include "planning/plan/terrain.h"

namespace gaitwright {

/// A straight path from start to goal in plan view, at constant speed from the first lift-off to the last touch-down,
/// at the nominal height above the ground below the feet; level.
BodyTrajectory StraightPath(const Terrain& terrain, const RigidBodyProblem& problem, double spacing_s);

/// Moves the path and the free footholds so that feet are within reach and near their nominal positions, and the path
/// is smooth. It minimises
///   sum_k (|p''_k| / 20 m/s^2)^2 + (|angles''_k| / 60 rad/s^2)^2 + (0.3 m |angles_k - wanted|)^2
///   + sum of squares of the distances of feet to their nominal positions, and of 30 times their distances out of
///     reach.
/// Footholds stay on their patches' planes, and in their regions.
void FitBodyTrajectory(RigidBodyProblem& problem, BodyTrajectory& trajectory);

/// Nominal position of a stance's foot, averaged over its time [m].
Vector3 WantedFoothold(const RigidBodyProblem& problem, const BodyTrajectory& trajectory, std::size_t stance);

/// Cost of a foothold on a path: the sum that FitBodyTrajectory minimises, over this stance.
double StanceMisfit(const RigidBodyProblem& problem, const BodyTrajectory& trajectory, std::size_t stance);

/// Smallest distance out of its workspace that a stance's foot can have in its region, for the given body pose, at the
/// worst time [m].
double LeastOutOfReach(const RigidBodyProblem& problem, std::size_t stance, const RigidBodyState& body);

/// The foot of a stance.
const RigidFoot& FootOf(const RigidBodyProblem& problem, std::size_t stance);

/// Distances of feet out of reach on a path.
struct BodyTrajectoryMisfit {
  double largest_m = 0.0, at_s = 0.0;
  double sum = 0.0;  ///< of squares, over times and sides [m^2]
  int stance = -1;   ///< the stance farthest out; -1 if all are within reach
};

/// Misfit of one stance's foot; below, of all feet.
BodyTrajectoryMisfit OutOfReach(const RigidBodyProblem& problem, const BodyTrajectory& trajectory, std::size_t stance);
BodyTrajectoryMisfit OutOfReach(const RigidBodyProblem& problem, const BodyTrajectory& trajectory);

}  // namespace gaitwright
