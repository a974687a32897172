// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/model/robot_model.h"
#include "planning/paths/base_path.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// Footholds of a schedule along a path of the base. A foothold is the foot's standing position under the base at the
/// middle of the stance (Raibert, Legged Robots That Balance, 1986). The first footholds are the standing positions at
/// the start; the last ones are the standing positions at the end of the path, for feet that swing at all. With two
/// feet, the foot on the side of a side-step or turn leads by half a cycle, so that the feet stay apart.
FootstepPlan PlaceAlongPath(const RobotModel& model, const Gait& gait, const ContactSchedule& schedule,
                            const BasePath& path, const PlanarTwist& twist);

/// Motion on a part of a path: a gait along a twist, or standing still.
struct PathStretch {
  double start_s = 0.0, end_s = 0.0;
  bool stands = false;
  double cycle_s = 0.0;  ///< cycle time of the gait
  PlanarTwist twist;     ///< twist of the gait's command
};

/// Footholds along several consecutive stretches. A stance that contains standing still has the standing footholds of
/// that time.
FootstepPlan PlaceAlongPath(const RobotModel& model, const ContactSchedule& schedule, const BasePath& path,
                            const std::vector<PathStretch>& stretches);

/// Footholds of counted footfalls, and the distance that they cover.
struct CountedFootsteps {
  FootstepPlan footsteps;
  int steps_to_goal = 0;  ///< number of steps of the twist between start and goal
};

/// Footholds of a schedule of counted footfalls, for any number of feet. Footfall k, in the order of lift-off, lands k
/// steps of the twist forward from the foot's start. Feet that land together all land as far as the last of them. The
/// goal is as far as the shortest of the feet's last footfalls, and no footfall goes beyond it, so that the last ones
/// close the stance. If some feet do not swing, the goal is the start. With two feet, the foot on the side opposite to
/// a side-step or turn lags by one step of it, so that the feet stay apart.
CountedFootsteps PlaceCounted(const RobotModel& model, const ContactSchedule& schedule, const PlanarTwist& step);

/// The foot of a biped that should swing first for counted side-steps or turns, so that no step is lost or narrows the
/// stance: the foot on the side of the motion; -1 for any foot.
int LeadingFoot(const RobotModel& model, const PlanarTwist& twist);

}  // namespace gaitwright
