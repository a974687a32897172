// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/base/result.h"
#include "kinematics/model/robot_model.h"
#include "planning/footsteps/course.h"
#include "planning/paths/plan_base_route.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// Where the base goes on a terrain for a command, from the origin facing x.
///   goal                       along the course's constant twist where that is free, else around what is in the way
///   distance, duration, steps  along the course; never around anything
/// `statistics.direct` tells whether it is the course.
/// @param course  of the command, as MakeCourse gives it.
/// Failures, kInfeasible: those of PlanBaseRoute; `start_blocked`; and `way_blocked` for a course that is not free,
/// which names what is in the way and how far the robot could go.
Result<BaseRoute> RouteOf(const RobotModel& model, const Terrain& terrain, const WalkCommand& command,
                          const Course& course, const BaseRouteOptions& options);

}  // namespace gaitwright
