// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "kinematics/base/result.h"
#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// Reason why a robot cannot walk for any command, or nothing. Failure kInfeasible:
///   `parallel_legs`  two legs turn about one axis on one side of the base: halves of one leg, whose loop is left open
///   `passive_joint`  a joint of a leg has no motor: see IsPassive
///   `no_support`  in its standing posture what its feet touch has no area: two point feet cannot stand still
///   `freedoms`    names a leg whose joints cannot move its foot in some direction there, or not keep its sole level,
///                 what it lacks, and the joints that it has
/// Lateral motion of a foot, and roll and yaw of a sole, are optional: without them the robot walks only forward and
/// backward.
std::optional<Failure> WhyCannotWalk(const RobotModel& model);

/// Why a robot that can walk cannot step sideways, or nothing. Failure kInfeasible `freedoms` names a leg that has no
/// joint to move its foot sideways, or none to keep its sole level sideways.
std::optional<Failure> WhyCannotSidestep(const RobotModel& model);

/// Why a robot that can walk cannot turn as it does, or nothing. Failure kInfeasible `freedoms` names a leg that has no
/// joint to turn its sole about the upright axis.
std::optional<Failure> WhyCannotTurn(const RobotModel& model);

}  // namespace gaitwright
