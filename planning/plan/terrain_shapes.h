// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/collision/shape_scene.h"
#include "planning/plan/terrain.h"

namespace gaitwright {

/// All solids of a terrain for collision checks: the solids under bounded patches (SolidUnder), half spaces below
/// infinite planes, the volume down to kSolidDepth below height fields, and the obstacles. Their names are those of the
/// terrain; unnamed ones get their kind and number, such as "patch 2".
/// @throws InvalidArgument for a height field without a height for each node.
ShapeScene SolidsOf(const Terrain& terrain);

/// The corners of a patch in plan view, in W; none of a plane without end.
std::vector<Vector2> PlanOutline(const TerrainPatch& patch);

/// The corners of an obstacle in W; of a cylinder those of a prism inside it.
std::vector<Vector3> CornersOf(const Obstacle& obstacle);

}  // namespace gaitwright
