// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/model/robot_model.h"
#include "planning/paths/base_path.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// Footholds of a schedule along a path of the base: each foot's standing position, moved with the base to its pose at
/// the middle of the stance (Raibert, Legged Robots That Balance, 1986). First footholds are those of standing at the
/// start, last ones those of standing at the path's end, as far as the foot swings at all. With two feet the one on the
/// side of a side-step or turn leads by half a cycle, so that the feet are kept apart.
FootstepPlan PlaceAlongPath(const RobotModel& model, const Gait& gait, const ContactSchedule& schedule,
                            const BasePath& path, const PlanarTwist& twist);

/// Motion on a part of a path: a gait along a twist, or standing still.
struct PathStretch {
  double start_s = 0.0, end_s = 0.0;
  bool stands = false;
  double cycle_s = 0.0;  ///< of the gait
  PlanarTwist twist;     ///< of the gait's command
};

/// Footholds along several consecutive stretches. A stance that spans a stretch of standing still has the standing
/// footholds there.
FootstepPlan PlaceAlongPath(const RobotModel& model, const ContactSchedule& schedule, const BasePath& path,
                            const std::vector<PathStretch>& stretches);

/// Footholds of counted footfalls, and how far they go.
struct CountedFootsteps {
  FootstepPlan footsteps;
  int steps_to_goal = 0;  ///< how many steps of the twist lie between start and goal
};

/// Footholds of a schedule of counted footfalls, for any number of feet. Footfall k, in the order of lifting off, lands
/// k steps of the twist ahead of where its foot stood at the start; feet that land together land as far as the last of
/// them. The goal is as far as the first of the feet's last footfalls goes and no footfall goes beyond it, so that the
/// last ones close the stance. Feet that do not swing stay, and then the goal is the start.
/// With two feet the one away from a side-step or turn lags a step of it, so that the feet are kept apart.
CountedFootsteps PlaceCounted(const RobotModel& model, const ContactSchedule& schedule, const PlanarTwist& step);

/// The foot that should swing first for counted side-steps or turns by two feet, so that no step is lost or narrows the
/// stance: the one on their side; -1 for any.
int LeadingFoot(const RobotModel& model, const PlanarTwist& twist);

}  // namespace gaitwright
