// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// Checks a given state (see RobotModel for its order).
/// @throws InvalidArgument for q or v of the wrong size, a number that is not finite, or a quaternion of length 0.
void CheckState(const RobotModel& model, const VectorX& q, const VectorX& v);

}  // namespace gaitwright
