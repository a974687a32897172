// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// Height of the middle of the hips over the origin of the base, in the base frame [m]; 0 without legs.
double HipsOverOrigin(const RobotModel& model);

/// The point of the base, in its frame, whose height over the ground tells whether the robot stands: the base's origin,
/// or the height of the hips above it where they are higher. The origin may be at the ground or below it, as that of a
/// `base_footprint`.
Vector3 HeightPoint(const RobotModel& model);

/// Height of the base's origin over level ground when HeightPoint is at this share of its standing height [m].
double BaseHeightAtShare(const RobotModel& model, double share);

}  // namespace gaitwright
