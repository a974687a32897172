// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/ik/leg_workspace.h"
#include "kinematics/spatial/pose.h"

namespace gaitwright {

/// The points p with normal . p <= offset.
struct WorkspaceSide {
  Vector3 normal = Vector3::UnitX();
  double offset = 0.0;
};

/// A convex part of what a leg reaches with its foot turned as in standing, about where it stands: the places of the
/// foot's controlled frame in the base, by the sides of a polytope [m]. Of the sides at right angles to 26 even
/// directions, those that are needed; along each of 218 rays from the standing place the polytope ends before the
/// leg's reach does, or its knee comes down to the ground under its foot, and by `farthest_m` at the latest.
/// @param up_B  out of the ground, with the base as in standing; zero for a foot in the air, where knees may be lower.
std::vector<WorkspaceSide> LegPolytope(LegWorkspace& workspace, double farthest_m, const Vector3& up_B);

}  // namespace gaitwright
