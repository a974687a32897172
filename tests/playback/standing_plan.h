// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/dynamics/contact_split.h"
#include "kinematics/dynamics/dynamics.h"
#include "kinematics/dynamics/foot_contact.h"
#include "kinematics/model/load_robot.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright::standing {

RobotModel Load(const std::string& name);

/// Adds one row at rest: joint torques and foot forces that carry the robot on level ground.
void AddRow(const RobotModel& model, const VectorX& q, WholeBodyTrajectory& trajectory);

/// Stands still in the nominal posture.
MotionPlan Plan(const RobotModel& model, double duration_s);

}  // namespace gaitwright::standing
