// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// Whether a joint coordinate has no motor: its effort limit is given as 0, and that of another coordinate is known.
/// For a coordinate of a leg, only those of the same leg are compared; otherwise those of the whole robot. If all
/// limits are 0, the author of the file did not know them, and the limits are unknown.
bool IsPassive(const RobotModel& model, int dof);

}  // namespace gaitwright
