// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// Poses of all bodies in the base frame O at the joint coordinates (size n). For making a model; motions take
/// ForwardKinematics, which allocates nothing.
std::vector<Pose> BodyPoses(const RobotModel& model, const VectorX& joints);

/// Indices of the joints from the base to a body, base first.
std::vector<int> ChainTo(const RobotModel& model, int body);

/// Those chains of two joints or more that lead to a body without children.
std::vector<std::vector<int>> Limbs(const RobotModel& model);

/// Whether moving `ancestor` moves `body`: it is that body or one of its ancestors.
bool Carries(const RobotModel& model, int ancestor, int body);

/// Of each body (nb), whether a joint of a leg moves it: not what legs carry besides.
std::vector<bool> BodiesOfLegs(const RobotModel& model);

/// Of each joint coordinate (n), whether it is of a leg.
std::vector<bool> DofsOfLegs(const RobotModel& model);

/// Of each joint coordinate (n), the leg that it is of, the last of those that share it, or -1.
std::vector<int> LegsOfDofs(const RobotModel& model);

}  // namespace gaitwright
