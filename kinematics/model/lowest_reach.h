// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// How low the end of a chain can come within the limits of its joints, in the base's frame at its upright [m]. The end
/// is a ball about the last joint that holds all of the last body. Each joint in turn goes to where that is lowest,
/// which has a closed form, until none gains any more.
/// @param chain  indices of joints, base first, at least one.
double LowestReach(const RobotModel& model, const std::vector<int>& chain);

}  // namespace gaitwright
