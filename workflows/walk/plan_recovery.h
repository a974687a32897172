// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/base/result.h"
#include "kinematics/model/robot_model.h"
#include "playback/control/recovering.h"

namespace gaitwright {

/// What 'recovering' needs of a robot: steps on the spot in the robot's own gait, as quick as they pass their audit,
/// or none where no steps do, and the joints of its protective crouch, on level ground.
/// Failure kInfeasible as of PlanPosture for a robot that cannot bend its legs.
Result<RecoveryPlans> PlanRecovery(const RobotModel& model);

}  // namespace gaitwright
