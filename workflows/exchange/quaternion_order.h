// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "planning/plan/terrain.h"
#include "workflows/exchange/motion_table.h"

namespace gaitwright {

/// Checks the order of quaternions. It evaluates the motion with quaternions as named and with w first: the robot
/// should be upright, with its lowest foot near the ground and not sliding. Heights count only if the robot is upright
/// with its feet near the ground in one of the orders; otherwise they are wrong for another reason, and only tilt and
/// sliding count.
///
/// A robot that stands in place looks the same in both orders if its rotation is zero in one order and pi in the other;
/// then the named order is used.
/// @param ground  the ground that the feet should be near; null if the motion has another world frame, so that heights
///                are unknown.
/// @param lift_m  added to the height of the base.
/// @throws InvalidArgument if the other order fits better, if both orders differ but fit nearly equally well, and if
/// the robot is upright in neither; its text names the options that set the order.
void CheckQuaternionOrder(const RobotModel& model, const Terrain* ground, double lift_m, const MotionTable& table);

}  // namespace gaitwright
