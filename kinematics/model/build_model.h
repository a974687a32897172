// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "kinematics/base/result.h"
#include "kinematics/model/robot_model.h"
#include "kinematics/model/urdf_shapes.h"

namespace gaitwright {

/// Bodies, joints, frames and shapes of a URDF that CheckUrdf has passed; legs and posture are left empty.
/// Fixed joints are merged into their parents with their frames kept by name; the rest is in document order made
/// topological. An inertia that is zero, or the same for all links whatever they weigh, is taken from the link's
/// shapes.
/// @param scale  by which the tree's lengths are multiplied; those of the shapes have it already. Masses and inertias
/// stay, as they do in Bullet. A joint beyond which nothing has inertia about its axis is
/// fixed, and where `strict` a failure. Failure: urdfdom refuses it (with its reason), or it has no mass.
Result<RobotModel> BuildModel(const UrdfParts& parts, const std::string& name, double scale, bool strict = false);

}  // namespace gaitwright
