// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "workflows/grade/mark_part_internal.h"
#include "workflows/grade/motion_run.h"

namespace gaitwright {

/// The robot of a part of motions. @throws InvalidArgument where it cannot be read.
RobotModel RobotOf(const RubricPart& part);

/// Makes a plan one of that command, which leads there from where its base starts. @throws InvalidArgument for a plan
/// without a motion.
void SetGoal(const WalkCommand& command, const PlanarPose& goal, MotionPlan& plan);

}  // namespace gaitwright
