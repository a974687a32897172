// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/dynamics/dynamics.h"
#include "kinematics/model/robot_model.h"
#include "kinematics/model/shape_support.h"

namespace gaitwright {

/// The lowest point of a shape at the scratch's pose, in W; the origin for a mesh without vertices.
Vector3 LowestPoint(const DynamicsScratch& scratch, const Shape& shape);

/// Whether a shape touches the ground together with its foot, so that planning, playback and audit use the foot instead
/// of it. These are the shapes of the foot's link, and shapes of its body that reach as low as the foot within 2 mm,
/// such as the box of an ankle from which the sole was derived.
bool IsShapeOfFoot(const Foot& foot, const Shape& shape);
/// Whether the shape belongs to any foot of the robot.
bool IsShapeOfAFoot(const RobotModel& model, const Shape& shape);

}  // namespace gaitwright
