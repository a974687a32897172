// SPDX-License-Identifier: BSD-3-Clause
// Good plans on grounds that are not level at height zero.
#pragma once

#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// The same motion at another place, rotated about z only, together with its ground.
MotionPlan CarriedWithGround(const Pose& X, MotionPlan plan);

/// Cuts a plan's ground to a slab around the origin of its patches, with an edge on each side at this distance.
void CutToSlab(MotionPlan& plan, double half_m);

/// Replaces a plan's ground by a level height field of this height.
void ReplaceByField(MotionPlan& plan, double height_m);

/// The robot of a plan standing still as at the plan's start, with robot and ground tilted by a rotation. Forces and
/// torques are computed for that.
MotionPlan StandOnSlope(const RobotModel& model, const MotionPlan& plan, const Matrix3& tilt);

}  // namespace gaitwright
