// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "optimisation/trajectory/body_problem_internal.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// Weighs the efforts of motors more whose root mean square passes the continuous limit in a plan, which is the law of
/// the audit. It is over a long time, so that no row of a knot can hold it.
/// @return whether there are any of which the weight is not at its largest yet.
bool CoolMotors(const RobotModel& model, const MotionPlan& plan, BodyWeights& weights);

}  // namespace gaitwright
