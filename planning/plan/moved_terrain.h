// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/base/result.h"
#include "planning/plan/terrain.h"

namespace gaitwright {

/// The ground as seen by a robot at another pose: moved, and rotated about z.
/// @param X  rotates about z only. Failure kInfeasible `turned_field` if the ground has a height field and X rotates:
///           the grid of a height field is parallel to x and y.
Result<Terrain> MovedTerrain(const Pose& X, Terrain terrain);

}  // namespace gaitwright
