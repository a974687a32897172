// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "kinematics/base/result.h"
#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// Bodies, joints, frames and shapes of a URDF that CheckUrdf has passed; legs and posture are left empty.
/// Fixed joints are merged into their parents with their frames kept by name; the rest is in document order made
/// topological. Failure: urdfdom refuses it, or everything beyond a joint has no inertia about its axis.
Result<RobotModel> BuildModel(const std::string& urdf_text, const std::string& name);

/// Poses of all bodies in the base frame at the joint coordinates (size n).
std::vector<Pose> BodyPoses(const RobotModel& model, const VectorX& joints);

}  // namespace gaitwright
