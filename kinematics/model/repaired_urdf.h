// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// The URDF of a robot with all repairs, so that strict loading accepts it. The text itself if nothing was repaired.
std::string RepairedUrdf(const RobotModel& model);

}  // namespace gaitwright
