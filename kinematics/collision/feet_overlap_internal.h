// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// Whether two feet overlap at a configuration: links that are fixed by their footholds, so that no motion of the rest
/// of the robot separates them. These are all links on the body of a sole, and links with a shape of a point or line
/// foot.
/// @param q  configuration, as StandingConfiguration makes it.
bool FeetOverlap(const RobotModel& model, const VectorX& q);

}  // namespace gaitwright
