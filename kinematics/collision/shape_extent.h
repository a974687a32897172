// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/dynamics/dynamics.h"
#include "kinematics/model/robot_model.h"
#include "kinematics/model/shape_support.h"

namespace gaitwright {

/// The lowest point of a shape at the scratch's pose, in W; of a mesh without vertices its origin.
Vector3 LowestPoint(const DynamicsScratch& scratch, const Shape& shape);

/// True for the shapes that touch the ground with their foot, so that playing, judging and planning take the foot for
/// them: those of the foot's link, and any of its body that reaches as low as it does, to 2 mm, as the box of an ankle
/// that its sole was derived from.
bool IsShapeOfFoot(const Foot& foot, const Shape& shape);
/// Whether the shape belongs to any foot of the robot.
bool IsShapeOfAFoot(const RobotModel& model, const Shape& shape);

}  // namespace gaitwright
