// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// q between two rows; the rotation by the shortest turn. @param u  0: q0, 1: q1.
void BlendPosture(const VectorX& q0, const VectorX& q1, double u, VectorX& q);

}  // namespace gaitwright
