// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// Mean height of the hips above the origin of the base, in the base frame [m]; 0 without legs.
double HipsOverOrigin(const RobotModel& model);

/// The point of the base, in its frame, whose height above the ground shows whether the robot stands: the origin of the
/// base, or the point above it at the height of the hips if they are higher. The origin of a base such as
/// `base_footprint` may be on or below the ground.
Vector3 HeightPoint(const RobotModel& model);

/// Height of the base's origin above level ground if HeightPoint is at this share of its standing height [m].
double BaseHeightAtShare(const RobotModel& model, double share);

}  // namespace gaitwright
