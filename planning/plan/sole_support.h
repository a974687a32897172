// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/spatial/convex_hull.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// Default distance of a sole's supported part from the edge of its surface [m].
inline constexpr double kEdgeMargin = 0.005;

/// The part of a sole on a patch, inside of the patch by a margin: the region where the ground can push.
/// @param sole_F  corners counter-clockwise in the xy plane of F [m].
/// @param X_WF    pose of the sole, in the plane of the patch.
/// @return in F [m]; the whole sole on an infinite plane; empty if no part of the sole is on the patch.
Polygon PartOnPatch(const std::vector<Vector2>& sole_F, const Pose& X_WF, const TerrainPatch& patch, double margin_m);

/// Whether a sole lies in the plane of the patch under its middle. False if it lies across several surfaces, such as
/// where a slope begins.
bool LiesOn(const TerrainPatch& patch, const Pose& X_WF, double most_tilt_rad = 1e-3);

/// The corners of a sole that touch the ground, to 2 mm, for a sole that lies across surfaces.
Polygon TouchingCorners(const std::vector<Vector2>& sole_F, const Pose& X_WF, const Terrain& terrain);

/// Sampling distance of soles on a height field, as a share of its resolution.
inline constexpr double kSoleSampling = 0.7;

/// A sole's corners and a lattice over the sole with at most this spacing, up to 25 by 25 points.
std::vector<Vector2> SoleSamples(const std::vector<Vector2>& sole_F, double spacing_m);

/// The hull of the part of a sole that touches a height field, to 0.5 mm.
Polygon TouchingPart(const std::vector<Vector2>& sole_F, const Pose& X_WF, const Terrain& terrain, double resolution_m);

/// The region on which a sole stands without rocking: the hull of the points that touch a height field exactly, and of
/// those that would touch if the sole rocked by 0.005 rad. For a sole on two opposite corners this is a narrow strip
/// between them, although TouchingPart is wide. The load must be inside of this region.
Polygon SteadyPart(const std::vector<Vector2>& sole_F, const Pose& X_WF, const Terrain& terrain, double resolution_m);

/// Support region of a foot at its foothold. Sole: the part on its surface, or TouchingCorners if it lies across
/// several surfaces. Line: the supported segment. Point or sphere: the contact point. In the contact frame's xy plane
/// [m], counter-clockwise; a corner in W is X_WF * (x, y, 0). Empty if no part is supported, or if the terrain has no
/// such surface.
Polygon SupportOf(const Foot& foot, const Foothold& foothold, const Terrain& terrain, double margin_m = kEdgeMargin);

/// Support regions of all footholds of a plan, in order, with kEdgeMargin. The whole foot is used for a foot without a
/// sole, and if no part of the sole is that far from an edge.
std::vector<Polygon> SupportsOf(const RobotModel& model, const Terrain& terrain, const FootstepPlan& footsteps);

}  // namespace gaitwright
