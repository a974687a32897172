// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "kinematics/model/robot_model.h"
#include "playback/trials/robustness_report.h"
#include "workflows/walk/walk.h"

namespace gaitwright {

/// The walk under the disturbances of examples/disturbances, with `stabilised` on a state estimated from hobby sensors.
RobustnessReport TriedByHobbySensors(const std::string& robot, const WalkRequest& walk, const std::string& disturbances,
                                     int trials, int seed);

}  // namespace gaitwright
