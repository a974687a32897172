// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "planning/plan/terrain.h"
#include "workflows/exchange/motion_table.h"

namespace gaitwright {

/// Sees to it that a motion can be what its file says, and brings its quaternions into the order x y z w.
///
/// Refused: too few rows, more than an hour, quaternions whose length is not 1 to a hundredth, values over 1e8; and
/// what is likely in other units or in another order than it is taken to be, with the option that says so: times in
/// milliseconds (rows half a second apart), angles in degrees (past the joints' limits, and within them as degrees),
/// lengths in millimetres, a quaternion with w first. For the last the motion is looked at in both orders: the robot is
/// to be upright, its lowest foot near the ground, and not to slide. Where the other order fits better it is named;
/// where both fit nearly alike and differ, which one it is has to be said. An option that is not at its usual value is
/// believed without that.
/// @throws InvalidArgument in these cases; the hint is in its text.
void CheckMotionTable(const RobotModel& model, const Terrain& terrain, const ImportOptions& options,
                      MotionTable& table);

}  // namespace gaitwright
