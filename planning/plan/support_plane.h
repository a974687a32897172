// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/stability/zero_moment_point.h"
#include "planning/plan/gait.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// Contact points by foot, in W [m]; those of feet off the ground are ignored.
using ContactsByFoot = std::vector<std::vector<Vector3>>;

/// The plane in which the ZMP of a stance is reckoned: through one foot's points, through the line of two and level
/// across it, or fitted to more (least squares).
GroundPlane PlaneThrough(const ContactsByFoot& contacts, FootSet stance);

/// The support plane at a time of a schedule, continuous at stance changes: at a change it is the plane of the feet
/// that stand before and after, with linear interpolation in between.
GroundPlane SupportPlaneAt(const ContactSchedule& schedule, double time_s, const ContactsByFoot& contacts);

/// The plane over which a pendulum's height counts: through the footholds of all feet, those of feet in the air evenly
/// on the straight way from the one left to the one to come. Feet that have no foothold yet do not count.
GroundPlane CarryingPlaneAt(const FootstepPlan& footsteps, int num_feet, double time_s);

/// The ground's normal under the foothold that a foot stands on, or stood on last; level when it has none.
Vector3 NormalUnder(const FootstepPlan& footsteps, int foot, double time_s);

/// The friction of the surface under that foothold; 0 when it has none.
double FrictionUnder(const Terrain& terrain, const FootstepPlan& footsteps, int foot, double time_s);

}  // namespace gaitwright
