// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/stability/zero_moment_point.h"
#include "planning/plan/gait.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// Contact points by foot, in W [m]; points of feet in the air are ignored.
using ContactsByFoot = std::vector<std::vector<Vector3>>;

/// The plane in which the ZMP of a stance is computed. One foot: through its points. Two feet: through the line between
/// them and level across it. More feet: least-squares fit.
GroundPlane PlaneThrough(const ContactsByFoot& contacts, FootSet stance);

/// The support plane at a time of a schedule. At a stance change it is the plane of the feet that stand before and
/// after; in between it is interpolated linearly, so it is continuous.
GroundPlane SupportPlaneAt(const ContactSchedule& schedule, double time_s, const ContactsByFoot& contacts);

/// The plane above which the pendulum's height is measured: through the footholds of all feet. A foot in the air counts
/// at a point that moves uniformly on the straight line from its last foothold to the next one. Feet without a foothold
/// are ignored.
GroundPlane CarryingPlaneAt(const FootstepPlan& footsteps, int num_feet, double time_s);

/// The ground's normal under the present or last foothold of a foot; vertical if the foot has none.
Vector3 NormalUnder(const FootstepPlan& footsteps, int foot, double time_s);

/// The friction coefficient under the present or last foothold of a foot; 0 if the foot has none.
double FrictionUnder(const Terrain& terrain, const FootstepPlan& footsteps, int foot, double time_s);

}  // namespace gaitwright
