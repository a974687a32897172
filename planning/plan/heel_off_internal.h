// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/spatial/convex_hull.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

// Heel-off: the last part of a stance, in which a sole stands on its front edge only and turns about it. The edge is
// parallel to y of F, so the sole's pose is X_WF of its foothold, turned by a pitch about that line; the heel is above
// the ground for a positive pitch. The swing starts from the turned pose.

/// Corners of a sole's front edge, at its largest x to 1 mm, by increasing y: two where the edge is straight [m].
/// @throws InvalidArgument for a sole without corners.
Polygon FrontEdge(const std::vector<Vector2>& sole_F);

/// Whether a foothold's sole stands on its front edge only, at a time of its stance.
bool StandsOnEdge(const Foothold& foothold, double time_s);

/// The part of a foot at a time that carries its load: `support_F`, that of the flat sole, or the front edge.
Polygon SupportAt(const Foot& foot, const Foothold& foothold, const Polygon& support_F, double time_s);

/// Middle of the front edge [m].
Vector3 EdgeMiddle(const Foot& foot);

/// Pose of a sole at X_WF after a turn about its front edge.
Pose TurnedAboutEdge(const Foot& foot, const Pose& X_WF, double pitch_rad);

/// How a pose differs from one that is only turned about the front edge.
struct EdgeTurn {
  double pitch_rad = 0.0;   ///< about the edge, positive with the heel up
  double turned_rad = 0.0;  ///< about other axes
  double off_m = 0.0;       ///< of the edge's corners, the largest distance
};
EdgeTurn EdgeTurnOf(const Foot& foot, const Pose& X_WF_flat, const Pose& X_WF);

}  // namespace gaitwright
