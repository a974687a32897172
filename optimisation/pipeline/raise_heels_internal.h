// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/model/robot_model.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// How heels rise before soles leave the ground.
struct HeelRise {
  double pitch_rad = 0.0;  ///< of the sole at lift-off, on the longest steps; in proportion to their lengths on others
  double share = 1.0;      ///< time of the rise over the shortest double support before such a lift-off
};

/// Adds heel-off to the footholds of a plan from which soles step forward, and lets their swings start from the turned
/// soles. The motion of the whole body stays: FinishMotion follows. A foothold stays flat if no other foot stands
/// before its lift-off, or if the ground does not carry the whole front edge.
void RaiseHeels(const RobotModel& model, const HeelRise& rise, MotionPlan& plan);

}  // namespace gaitwright
