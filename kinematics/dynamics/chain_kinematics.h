// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/dynamics/dynamics.h"

namespace gaitwright {

/// Joints between the base and a body, from the base on.
std::vector<int> JointsTo(const RobotModel& model, int body);

/// ForwardKinematics of the base and of the bodies beyond some joints only, which are in order from the base on: with
/// those of JointsTo a body, all that PointJacobian and FramePose of that body need.
void ChainKinematics(const RobotModel& model, const VectorX& q, const std::vector<int>& joints,
                     DynamicsScratch& scratch);

}  // namespace gaitwright
