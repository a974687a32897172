// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// The URDF of a robot with all that was mended written into it, so that strict loading takes it. The text itself where
/// nothing was.
std::string RepairedUrdf(const RobotModel& model);

}  // namespace gaitwright
