// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/dynamics/foot_contact.h"
#include "kinematics/spatial/rotation.h"
#include "planning/plan/sample_plan.h"
#include "playback/control/controller.h"

/// What a controller measures of a robot that is not quite where its plan has it.
namespace gaitwright::displaced {

/// The robot exactly on its plan, the scheduled feet on the ground with the planned wrenches.
ControlInput OnPlan(const MotionPlan& plan, double time_s);

/// Rows of a foot's position, and of a sole's turn, against all of v: the frame Foot::X_BF.
MatrixX FootRows(const RobotModel& model, const DynamicsScratch& scratch, int foot);

/// The joints with which the feet are at X_WF though the base of q is elsewhere.
VectorX FeetAt(const RobotModel& model, const std::vector<Pose>& X_WF, VectorX q);

/// The base moved and turned (rotation vector, W, about its origin), the feet where they were.
VectorX BaseMoved(const RobotModel& model, const VectorX& q, const Vector3& way_W, const Vector3& turn_W);

/// What is measured of a robot that is elsewhere.
ControlInput Carried(const Pose& X, ControlInput input);

/// The same motion elsewhere, with its ground.
MotionPlan Carried(const Pose& X, MotionPlan plan);

}  // namespace gaitwright::displaced
