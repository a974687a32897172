// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/model/robot_model.h"
#include "optimisation/centroidal/plan_rigid_body.h"

namespace gaitwright {

/// Scales the default options, which suit a small quadruped at a trot, to a robot and its gait. Near the motors' speed
/// limit, forces must end abruptly at lift-off, which needs a smaller node spacing. The weight of the feet's distance
/// from their nominal positions scales with the leg length. Before a long flight the body moves down and up a lot, so
/// its position above the feet has less weight.
/// @param flight_s      the longest flight; 0 for none
/// @param rise_max_m_s  largest rising speed at lift-off that the motors allow; 0 without a bound
RigidBodyOptions FittedOptions(const RobotModel& model, double flight_s, double rise_max_m_s, RigidBodyOptions options);

}  // namespace gaitwright
