// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/spatial/convex_hull.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// Default distance of a sole's supported part from the edge of its surface [m].
inline constexpr double kEdgeMargin = 0.005;

/// The part of a sole that is on a patch, by a margin to its edge: where the ground can push.
/// @param sole_F  corners counter-clockwise in the xy plane of F [m].
/// @param X_WF    pose of the sole, in the plane of the patch.
/// @return in F [m]; the whole sole on a plane without end, empty when nothing is left.
Polygon PartOnPatch(const std::vector<Vector2>& sole_F, const Pose& X_WF, const TerrainPatch& patch, double margin_m);

/// Whether a sole lies in the plane of the patch under its middle rather than across several surfaces, such as in the
/// corner where a slope begins.
bool LiesOn(const TerrainPatch& patch, const Pose& X_WF, double most_tilt_rad = 1e-3);

/// The corners of a sole in contact with the ground, to two millimetres, for a sole that lies across surfaces.
Polygon TouchingCorners(const std::vector<Vector2>& sole_F, const Pose& X_WF, const Terrain& terrain);

/// Sampling distance of soles on a height field, as a share of its resolution.
inline constexpr double kSoleSampling = 0.7;

/// A sole's corners, and a lattice over it that is at most so wide, up to 25 by 25.
std::vector<Vector2> SoleSamples(const std::vector<Vector2>& sole_F, double spacing_m);

/// The hull of what of a sole touches a height field, to half a millimetre.
Polygon TouchingPart(const std::vector<Vector2>& sole_F, const Pose& X_WF, const Terrain& terrain, double resolution_m);

/// What of a sole holds its middle without rocking: the hull of what touches a height field exactly, and of what would
/// if the sole rocked by 0.005 rad. Where a sole lies on two opposite corners it is a narrow strip between them,
/// although TouchingPart is wide: the load has to be inside of it.
Polygon SteadyPart(const std::vector<Vector2>& sole_F, const Pose& X_WF, const Terrain& terrain, double resolution_m);

/// Support region of a foot at its foothold: for a sole the part on its surface, or TouchingCorners if it lies across
/// several; of a line the same, up to a segment; of a point or sphere the contact point. In the contact frame's xy
/// plane [m], counter-clockwise: corners in W are X_WF * (x, y, 0). Empty if no part is supported, or if the terrain
/// has no such surface.
Polygon SupportOf(const Foot& foot, const Foothold& foothold, const Terrain& terrain, double margin_m = kEdgeMargin);

/// Support regions of all footholds of a plan, in order, with kEdgeMargin; for a foot without a sole, or if no part is
/// that far from an edge, the whole foot.
std::vector<Polygon> SupportsOf(const RobotModel& model, const Terrain& terrain, const FootstepPlan& footsteps);

}  // namespace gaitwright
