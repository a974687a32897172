// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/spatial/convex_hull.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// Distance from the edge of a surface that the part of a sole on it keeps [m], where nothing else is asked for.
inline constexpr double kEdgeMargin = 0.005;

/// The part of a sole that is on a patch, by a margin to its edge: where the ground can push.
/// @param sole_F  corners counter-clockwise in the xy plane of F [m].
/// @param X_WF    pose of the sole, in the plane of the patch.
/// @return in F [m]; the whole sole on a plane without end, empty when nothing is left.
Polygon PartOnPatch(const std::vector<Vector2>& sole_F, const Pose& X_WF, const TerrainPatch& patch, double margin_m);

/// Where the ground can push a foot at its foothold: of a sole the part on its surface, of a line the same, up to a
/// segment; of a point or sphere the contact point. In the contact frame's xy plane [m], counter-clockwise: corners in
/// W are X_WF * (x, y, 0). Empty where nothing is on, or when the terrain has no such surface.
Polygon SupportOf(const Foot& foot, const Foothold& foothold, const Terrain& terrain, double margin_m = kEdgeMargin);

/// The same of all footholds of a plan, in their order, by kEdgeMargin; of a foot without a sole, or where nothing is
/// that far from an edge, all of it.
std::vector<Polygon> SupportsOf(const RobotModel& model, const Terrain& terrain, const FootstepPlan& footsteps);

}  // namespace gaitwright
