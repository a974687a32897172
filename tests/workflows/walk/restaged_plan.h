// SPDX-License-Identifier: BSD-3-Clause
// A plan whose later stages are made anew after an earlier one was changed, so that all columns agree with each other.
#pragma once

#include "kinematics/model/robot_model.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// Swings, joints, torques and forces anew from the footholds, centre of mass and swings' lifts that the plan has; the
/// reference of the ZMP is what they do.
MotionPlan WithWholeBodyAnew(const RobotModel& maker, MotionPlan plan);

/// The same, with the centre of mass planned anew for the plan's footholds first.
MotionPlan WithMotionAnew(const RobotModel& maker, MotionPlan plan);

/// Adds a shift to the reference of the ZMP in a range of phases of the schedule, rising over the phase before and
/// falling over the one after; and to the centre of mass what the pendulum makes of it.
void ShiftZmp(const Vector2& shift_W, int first_phase, int last_phase, MotionPlan& plan);

}  // namespace gaitwright
