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

/// A convex part of the reach of a leg around the standing position of its foot, with the rotation of the foot as in
/// standing. It is a polytope of positions of the foot's controlled frame in the base [m]. Its sides are normal to 26
/// evenly spread directions; redundant sides are left out. Along each of 218 rays from the standing position, the
/// polytope ends before the reach of the leg ends, before the knee comes close to the ground below the foot, and at
/// `farthest_m` at most.
/// @param up_B  normal of the ground, with the base as in standing; zero for a foot in the air, where knees may be
/// lower.
std::vector<WorkspaceSide> LegPolytope(LegWorkspace& workspace, double farthest_m, const Vector3& up_B);

}  // namespace gaitwright
