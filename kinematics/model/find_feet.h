// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/model/derive_legs.h"
#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// Distance from a body's joint to the farthest of its collision geometry and its frames [m].
double FarthestExtent(const RobotModel& model, int body);

/// The foot at the end of a leg; X_BF has the base's axes at joint positions zero (a sphere's are set with the
/// posture).
Foot FindFoot(const RobotModel& model, const Leg& leg, const FootOverride* given);

}  // namespace gaitwright
