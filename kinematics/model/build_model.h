// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "kinematics/base/result.h"
#include "kinematics/model/robot_model.h"
#include "kinematics/model/urdf_shapes.h"

namespace gaitwright {

/// Bodies, joints, frames and shapes of a URDF that CheckUrdf has passed; legs and posture are left empty.
/// Fixed joints are merged into their parents with their frames kept by name; the rest is in document order made
/// topological. Failure: urdfdom refuses it (with its reason), it has no mass, or everything beyond a joint has no
/// inertia about its axis.
Result<RobotModel> BuildModel(const UrdfParts& parts, const std::string& name);

}  // namespace gaitwright
