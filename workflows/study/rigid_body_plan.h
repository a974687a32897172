// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/base/result.h"
#include "optimisation/centroidal/rigid_body_motion.h"
#include "planning/audit/audit_report.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// The motion of a single rigid body as a plan of its robot (rigid_body_robot.h): rows `step_s` apart, feet on their
/// footholds and on swings planned over the ground (plan_swings.h) within their workspaces, joints in closed form,
/// forces those of the motion, torques by inverse dynamics.
/// Failures as those of PlanSwings. @throws InvalidArgument where the robot is not that of the problem, or for a
/// problem with inner momentum or contacts that move.
Result<MotionPlan> RigidBodyMotionPlan(const RobotModel& robot, const Terrain& ground, const RigidBodyProblem& problem,
                                       const RigidBodyMotion& motion, double step_s = 5e-4);

/// The audit of a motion of a rigid body over a ground: all laws, at 1 kHz. Failures as those of RigidBodyMotionPlan.
Result<AuditReport> AuditRigidBody(const Terrain& ground, const RigidBodyProblem& problem,
                                   const RigidBodyMotion& motion);

}  // namespace gaitwright
