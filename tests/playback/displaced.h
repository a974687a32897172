// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/dynamics/foot_contact.h"
#include "kinematics/spatial/rotation.h"
#include "planning/plan/sample_plan.h"
#include "playback/control/controller.h"

/// Measurements of a robot that is displaced from its plan.
namespace gaitwright::displaced {

/// The robot exactly on its plan, the scheduled feet on the ground with the planned wrenches.
ControlInput OnPlan(const MotionPlan& plan, double time_s);

/// Rows of a foot's position, and of a sole's rotation, with respect to all of v: the frame Foot::X_BF.
MatrixX FootRows(const RobotModel& model, const DynamicsScratch& scratch, int foot);

/// The joints that put the feet at X_WF for the base of q.
VectorX FeetAt(const RobotModel& model, const std::vector<Pose>& X_WF, VectorX q);

/// The base moved and turned (rotation vector, W, about its origin); the feet stay in place.
VectorX BaseMoved(const RobotModel& model, const VectorX& q, const Vector3& displacement_W, const Vector3& turn_W);

/// Measurements of the robot at another place.
ControlInput Carried(const Pose& X, ControlInput input);

/// The same motion at another place, including its ground.
MotionPlan Carried(const Pose& X, MotionPlan plan);

}  // namespace gaitwright::displaced
