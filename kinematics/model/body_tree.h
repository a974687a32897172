// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// Poses of all bodies in the base frame O at the joint coordinates (size n). For building a model; motions use
/// ForwardKinematics, which does not allocate memory.
std::vector<Pose> BodyPoses(const RobotModel& model, const VectorX& joints);

/// The same of the last body of a chain (ChainTo), equal to that of BodyPoses.
Pose PoseAlong(const RobotModel& model, const std::vector<int>& chain, const VectorX& joints);

/// Indices of the joints from the base to a body, base first.
std::vector<int> ChainTo(const RobotModel& model, int body);

/// The chains of two or more joints that end in a body without children.
std::vector<std::vector<int>> Limbs(const RobotModel& model);

/// Whether moving `ancestor` moves `body`: it is that body or one of its ancestors.
bool Carries(const RobotModel& model, int ancestor, int body);

/// For each body (nb), whether a joint of a leg moves it. False for other parts that hang on a leg.
std::vector<bool> BodiesOfLegs(const RobotModel& model);

/// For each joint coordinate (n), whether it belongs to a leg.
std::vector<bool> DofsOfLegs(const RobotModel& model);

/// For each joint coordinate (n), the index of its leg, or -1. If several legs share the coordinate, the last one.
std::vector<int> LegsOfDofs(const RobotModel& model);

}  // namespace gaitwright
