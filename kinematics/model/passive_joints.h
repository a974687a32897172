// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// Whether a joint coordinate has no motor: its effort limit is given as 0, and that of another one is not. In a leg
/// the others of that leg count; elsewhere those of the whole robot. Where all are 0 the file's author did not know
/// them, and the limits are unknown.
bool IsPassive(const RobotModel& model, int dof);

}  // namespace gaitwright
