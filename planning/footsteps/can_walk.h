// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "kinematics/base/result.h"
#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// Reason why a robot cannot walk for any command, or nothing. Failure kInfeasible:
///   `parallel_legs`  two legs turn about one axis on one side of the base: halves of one leg with an open loop
///   `passive_joint`  a joint of a leg has no motor: see IsPassive
///   `no_support`     the contacts of the standing posture span no area, and the robot is no biped, which could fall
///                    from foot to foot; or its feet have no shape
///   `freedoms`       a leg cannot move its foot in some direction, or cannot keep its sole level; names the leg,
///                    the missing motion and the joints of the leg
/// Lateral motion of a foot, and roll and yaw of a sole, are optional: without them the robot walks only forward and
/// backward.
std::optional<Failure> ReasonCannotWalk(const RobotModel& model);

/// Reason why a robot cannot stand still, or nothing. Failure kInfeasible `no_support`: its feet touch the ground in
/// points on a line.
std::optional<Failure> ReasonCannotStand(const RobotModel& model);

/// Reason why a robot that can walk cannot step sideways, or nothing. Failure kInfeasible `freedoms` names a leg
/// without a joint that moves its foot sideways, or without a joint that keeps its sole level in roll.
std::optional<Failure> ReasonCannotSidestep(const RobotModel& model);

/// Reason why a robot that can walk cannot turn while it walks, or nothing. Failure kInfeasible `freedoms` names a leg
/// without a joint that yaws its sole.
std::optional<Failure> ReasonCannotTurn(const RobotModel& model);

}  // namespace gaitwright
