// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// Lowest height that the end of a chain can reach within the limits of its joints, in the frame of the upright base
/// [m]. The end is a sphere about the last joint that contains the last body. The joints go in turn to the position at
/// which the end is lowest (closed form), until no joint improves.
/// @param chain  indices of joints, base first, at least one.
double LowestReach(const RobotModel& model, const std::vector<int>& chain);

}  // namespace gaitwright
