// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/collision/shape_scene.h"
#include "planning/plan/terrain.h"

namespace gaitwright {

/// All that is solid of a terrain, to hold shapes against: the solids under bounded patches (SolidUnder), all that is
/// below planes without end, what is down to kSolidDepth below height fields, and the obstacles. Their names are those
/// of the terrain; what has none is called by its kind and its number there, as in "patch 2".
/// @throws InvalidArgument for a height field without a height for each node.
ShapeScene SolidsOf(const Terrain& terrain);

/// The corners of a patch in plan view, in W; none of a plane without end.
std::vector<Vector2> PlanOutline(const TerrainPatch& patch);

/// The corners of an obstacle in W; of a cylinder those of a prism inside it.
std::vector<Vector3> CornersOf(const Obstacle& obstacle);

}  // namespace gaitwright
