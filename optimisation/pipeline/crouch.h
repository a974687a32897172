// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "kinematics/base/result.h"
#include "kinematics/model/robot_model.h"
#include "planning/plan/gait.h"

namespace gaitwright {

/// Lowered posture of a robot whose standing legs are too straight for a take-off, or that has a given height. With
/// nearly stretched legs, joints rotate fast for a small speed of the body.
struct Crouch {
  RobotModel model;  ///< the robot, with the crouch as its standing posture
  Vector3 p_SB =
      Vector3::Zero();     ///< horizontal shift of the base relative to its feet, from standing to the crouch [m]
  double highest_m = 0.0;  ///< largest height of the centre of mass above a foothold at lift-off and touch-down; 0: any
  double flight_s = 0.0;   ///< the longest flight, if the crouch is for flights
  double fastest_m_s = 0.0;  ///< largest vertical speed that the motors allow there; 0: any
};

/// The crouch that the flights of a schedule need: a flight of duration T begins with an upward speed of g T / 2, for
/// which the motors' speeds need a margin at lift-off. Nothing if standing has this margin, too. Failure kInfeasible
/// `legs_too_slow` or `legs_too_weak` if no height gives this speed plus 15 %, which a push reaches before its force
/// decreases, with a level base and flat soles. The reason is the motors' speeds at that height, or their torques
/// during the rise from the deepest crouch, along their torque-speed curves. Failure kInfeasible `height` if the centre
/// of mass cannot be at the requested height, or if legs are not fast enough there.
/// @param com_height_m  requested height above flat ground; 0 uses the height that flights need.
Result<std::optional<Crouch>> CrouchFor(const RobotModel& model, const ContactSchedule& schedule,
                                        double com_height_m = 0.0);

}  // namespace gaitwright
