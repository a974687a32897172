// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "workflows/grade/mark_part_internal.h"
#include "workflows/grade/motion_run.h"

namespace gaitwright {

/// The robot of a motion part. @throws InvalidArgument if it cannot be read.
RobotModel RobotOf(const RubricPart& part);

/// Replaces a plan's command by the given one, with the goal relative to the start of its base. @throws InvalidArgument
/// for a plan without a motion.
void SetGoal(const WalkCommand& command, const PlanarPose& goal, MotionPlan& plan);

}  // namespace gaitwright
