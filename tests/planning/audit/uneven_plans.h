// SPDX-License-Identifier: BSD-3-Clause
// Good plans on grounds that are not level and at zero height.
#pragma once

#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// The same motion elsewhere, turned about z at most, with its ground.
MotionPlan CarriedWithGround(const Pose& X, MotionPlan plan);

/// A plan's ground cut to a slab about the origin of its patches, with an edge at each side this far away.
void CutToSlab(MotionPlan& plan, double half_m);

/// A level height field of this height in place of a plan's ground.
void ReplaceByField(MotionPlan& plan, double height_m);

/// The robot of a plan standing still as it does at the plan's start, the whole turned by a rotation that tilts the
/// ground; forces and torques as that needs.
MotionPlan StandOnSlope(const RobotModel& model, const MotionPlan& plan, const Matrix3& tilt);

}  // namespace gaitwright
