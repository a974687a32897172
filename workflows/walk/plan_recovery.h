// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/base/result.h"
#include "kinematics/model/robot_model.h"
#include "playback/control/recovering.h"

namespace gaitwright {

/// Plans that 'recovering' needs for a robot, on level ground: steps in place in the robot's default gait, at the
/// fastest cycle that passes the audit (none if no cycle does), and the joint positions of its protective crouch.
/// Failure kInfeasible as of PlanPosture for a robot that cannot bend its legs.
Result<RecoveryPlans> PlanRecovery(const RobotModel& model);

}  // namespace gaitwright
