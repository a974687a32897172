// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/base/result.h"
#include "kinematics/model/robot_model.h"
#include "planning/footsteps/course.h"
#include "planning/paths/plan_base_route.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// Route of the base on a terrain for a command, from the origin facing x.
///   goal                       along the course's constant twist if that is free, otherwise around obstacles
///   distance, duration, steps  along the course; never around obstacles
/// `statistics.direct` is true if the route is the course.
/// @param course  course of the command, from MakeCourse.
/// Failures, kInfeasible: those of PlanBaseRoute; `start_blocked`; `way_blocked` for a course that is not free (names
/// the obstacle and the free distance).
Result<BaseRoute> RouteOf(const RobotModel& model, const Terrain& terrain, const WalkCommand& command,
                          const Course& course, const BaseRouteOptions& options);

}  // namespace gaitwright
