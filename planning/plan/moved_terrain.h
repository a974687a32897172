// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/base/result.h"
#include "planning/plan/terrain.h"

namespace gaitwright {

/// The same ground moved, and turned about z: what a robot that is elsewhere, or higher, has before it.
/// @param X  turns about z alone.
/// Failure kInfeasible `turned_field` for a height field that would be turned, since its grid lies along x and y.
Result<Terrain> MovedTerrain(const Pose& X, Terrain terrain);

}  // namespace gaitwright
