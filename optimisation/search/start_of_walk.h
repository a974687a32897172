// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/model/robot_model.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// The start of the same walk: long enough to reach full speed, keep it for some cycles and stop again.
WalkCommand StartOfWalk(const RobotModel& model, const WalkCommand& command, const Gait& gait);

/// Whether a walk is hardly longer than its start, so that it costs no more to plan it whole.
bool IsShort(const RobotModel& model, const WalkCommand& command, const Gait& gait);

}  // namespace gaitwright
