// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/spatial/convex_hull.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// The part of a foothold's sole that is on its surface, at least `margin_m` inside the surface's edge, in F [m]: all
/// that the foot can push through. Of a foot without a sole its one point. Empty when nothing is on, or when the
/// terrain has no such surface.
Polygon SupportedSole(const Terrain& terrain, const Foot& foot, const Foothold& foothold, double margin_m);

}  // namespace gaitwright
