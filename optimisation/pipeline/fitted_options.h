// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/model/robot_model.h"
#include "optimisation/centroidal/plan_rigid_body.h"

namespace gaitwright {

/// Options that are given for an A1 at a trot, fitted to a robot and its gait.
/// Near the motors' greatest speed forces are to end at once at lift-off, for which breaks are nearer to each other.
/// How far feet are from where they like to stand counts by the leg's length. A body that is thrown up far goes down
/// and up as far before: where it is over its feet then matters less.
/// @param flight_s      the longest flight; 0 for none
/// @param rise_max_m_s  that motors let the body rise at lift-off; 0 where they set no bound
RigidBodyOptions FittedOptions(const RobotModel& model, double flight_s, double rise_max_m_s, RigidBodyOptions options);

}  // namespace gaitwright
