// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/dynamics/dynamics.h"

namespace gaitwright {

/// Joints between the base and a body, base first.
std::vector<int> JointsTo(const RobotModel& model, int body);

/// ForwardKinematics of the base and of the bodies of some joints only. With the joints of JointsTo a body,
/// PointJacobian and FramePose of that body are valid.
/// @param joints  base first.
void ChainKinematics(const RobotModel& model, const VectorX& q, const std::vector<int>& joints,
                     DynamicsScratch& scratch);

}  // namespace gaitwright
