// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/collision/shape_scene.h"
#include "planning/plan/terrain.h"

namespace gaitwright {

/// All solids of a terrain for collision checks: the solids under bounded patches (SolidUnder), half spaces below
/// infinite planes, the volume below height fields down to kSolidDepth, and the obstacles. They have the names of the
/// terrain; unnamed ones get their kind and number, such as "patch 2".
/// @throws InvalidArgument for a height field without a height for each node.
ShapeScene SolidsOf(const Terrain& terrain);

/// Those of them that are convex: all but the volumes below height fields.
FixedSolids ConvexSolidsOf(const Terrain& terrain);

/// The corners of a patch in plan view, in W; empty for an infinite plane.
std::vector<Vector2> PlanOutline(const TerrainPatch& patch);

/// The corners of an obstacle in W; for a cylinder, the corners of an inscribed prism.
std::vector<Vector3> CornersOf(const Obstacle& obstacle);

}  // namespace gaitwright
