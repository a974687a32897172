// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "kinematics/base/result.h"
#include "kinematics/model/robot_model.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// Shape of the first guess of a leap in which the body turns over.
struct LeapShape {
  double push_s = 0.0;      ///< from the start of the turn until the last feet lift off; also for the landing
  double crouch_s = 0.0;    ///< from standing to the lowest posture, and from landing to standing
  double extended = 0.80;   ///< length of the last legs at lift-off, as a share of the leg length
  double crouched = 0.50;   ///< height of the hips in the crouch, as a share of the leg length
  double tucked = 0.50;     ///< length of the legs in flight, as a share of the leg length
  double ramp_power = 2.0;  ///< the turning rate rises with this power of time during the push
};

/// Times that suit a robot: they scale with sqrt(leg length / g).
LeapShape LeapShapeOf(const RobotModel& model);

/// Sets the rows of a plan with one leap to a motion in which the body turns over about a horizontal axis while the
/// centre of mass flies freely: a first guess for FinishMotion. Over the push, the body turns about the hips of the
/// feet that lift off last; the landing is its mirror image. In flight the legs are tucked in.
///
/// @param plan    has a schedule, footholds and swings of one leap, and the robot stands before and after.
/// @param turn_W  rotation vector of the whole turn, about a horizontal axis [rad].
/// @return the first row that legs do not reach, as a failure kInfeasible.
std::optional<Failure> SetTurningLeap(const RobotModel& model, const Vector3& turn_W, const LeapShape& shape,
                                      double step_s, MotionPlan& plan);

/// Sets the curves of all swings to the motion of the feet in the rows of a plan: start, end and detour.
void FitSwings(const RobotModel& model, MotionPlan& plan);

}  // namespace gaitwright
