// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/base/result.h"
#include "optimisation/centroidal/rigid_body_motion.h"
#include "planning/audit/audit_report.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// Converts the motion of a single rigid body to a plan of its robot (rigid_body_robot.h): rows `step_s` apart, feet on
/// their footholds or on swings planned above the ground (plan_swings.h) within their workspaces, joint positions in
/// closed form, the motion's contact forces, and torques by inverse dynamics. Failures as of PlanSwings. @throws
/// InvalidArgument if the robot does not belong to the problem, or for a problem with leg angular momentum or moving
/// contacts.
Result<MotionPlan> RigidBodyMotionPlan(const RobotModel& robot, const Terrain& ground, const RigidBodyProblem& problem,
                                       const RigidBodyMotion& motion, double step_s = 5e-4);

/// The audit of a rigid body's motion over a ground: all checks, at 1 kHz. Failures as of RigidBodyMotionPlan.
Result<AuditReport> AuditRigidBody(const Terrain& ground, const RigidBodyProblem& problem,
                                   const RigidBodyMotion& motion);

}  // namespace gaitwright
