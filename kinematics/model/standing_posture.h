// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// Fills standing_joints, standing_base_height_m and the axes of spherical feet. Needs legs and feet.
/// @param given  joint positions by coordinate; NaN for positions that are derived.
void DeriveStanding(RobotModel& model, const VectorX& given);

}  // namespace gaitwright
