// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/base/result.h"
#include "planning/plan/terrain.h"

namespace gaitwright {

/// A ground that is moved and rotated about z: the ground as seen by a robot at another pose.
/// @param X  rotates about z only. Failure kInfeasible `turned_field` for a height field that would be turned, since
/// its grid lies along x and y.
Result<Terrain> MovedTerrain(const Pose& X, Terrain terrain);

}  // namespace gaitwright
