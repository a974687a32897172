// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// Smallest width of the area on which all feet of the standing posture touch level ground, in any direction [m].
double StandingWidth(const RobotModel& model);

/// Least width on which a robot can stand still [m]: 1 % of the length of its legs.
double LeastStandingWidth(const RobotModel& model);

/// Whether a robot can stand still on its feet. A biped with two points as feet cannot.
bool CanStandStill(const RobotModel& model);

}  // namespace gaitwright
