// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "kinematics/base/result.h"
#include "kinematics/model/robot_model.h"
#include "planning/plan/gait.h"

namespace gaitwright {

/// Lowered posture of a robot whose standing legs are too straight for a take-off (with nearly stretched legs, joints
/// turn fast for a small speed of the body), or that has a given height.
struct Crouch {
  RobotModel model;                ///< the robot, its standing posture that of crouching
  Vector3 p_SB = Vector3::Zero();  ///< from where the base is over its feet in standing to where it is now, level [m]
  double highest_m = 0.0;          ///< of the centre of mass over a foothold, at lift-off and touch-down; 0: any
  double flight_s = 0.0;           ///< the longest flight, if the crouch is for flights
  double fastest_m_s = 0.0;        ///< that the motors let the body rise or sink there; 0: any
};

/// The crouch that the flights of a schedule need: a flight of a duration T begins with an upward speed of g T / 2,
/// for which the motors' speeds are to have a reserve at lift-off. Nothing where standing has it too.
/// Failure kInfeasible `legs_too_slow`, `legs_too_weak` where no height gives that speed and 0.15 more, which a push is
/// faster by before its force has come down, base level and soles flat: the motors' speeds at that height do not, or
/// their torques over the way up from the deepest crouch.
/// Failure kInfeasible `height` where the centre of mass cannot be where it is asked for, or legs are not fast enough
/// there.
/// @param com_height_m  over flat ground, rather than where flights need it; 0 for that.
Result<std::optional<Crouch>> CrouchFor(const RobotModel& model, const ContactSchedule& schedule,
                                        double com_height_m = 0.0);

}  // namespace gaitwright
