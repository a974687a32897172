// SPDX-License-Identifier: BSD-3-Clause
// Plans whose later stages are computed again after a change of an earlier stage, so that all columns agree.
#pragma once

#include "kinematics/model/robot_model.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// Computes swings, joints, torques and forces again from the plan's footholds, centre of mass and swing lifts; the ZMP
/// reference becomes the resulting ZMP.
MotionPlan WithWholeBodyAnew(const RobotModel& maker, MotionPlan plan);

/// As above, after planning the centre of mass again for the plan's footholds.
MotionPlan WithMotionAnew(const RobotModel& maker, MotionPlan plan);

/// Adds a shift to the ZMP reference in a range of phases of the schedule, rising over the phase before and falling
/// over the phase after, and adds the pendulum's response to the centre of mass.
void ShiftZmp(const Vector2& shift_W, int first_phase, int last_phase, MotionPlan& plan);

}  // namespace gaitwright
