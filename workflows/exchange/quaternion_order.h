// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "planning/plan/terrain.h"
#include "workflows/exchange/motion_table.h"

namespace gaitwright {

/// Looks at a motion with its quaternions as they are and with w first: the robot is to be upright, and its lowest foot
/// near the ground and not sliding. Heights count where one of the orders has the robot upright with its feet near the
/// ground; where none has, they are wrong for another reason, and tilt and slide alone are judged.
///
/// What stands on the spot looks alike in both orders where it is turned by no angle in the one and by pi in the other;
/// it is taken as it is named.
/// @param ground  what the feet are to be near; null where the motion's world is its own, so that heights say nothing.
/// @param lift_m  added to the height of the base.
/// @throws InvalidArgument where the other order fits better, where both fit nearly alike and differ, and where the
/// robot is upright in neither; the options that say the order are in its text.
void CheckQuaternionOrder(const RobotModel& model, const Terrain* ground, double lift_m, const MotionTable& table);

}  // namespace gaitwright
