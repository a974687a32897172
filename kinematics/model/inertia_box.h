// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// The box of one density that has a body's mass and inertia, about its centre of mass and along its principal axes.
/// Nothing where the body has no mass or no inertia.
std::optional<Shape> InertiaBox(const RobotModel& model, int body);

/// Gives the bodies whose collision meshes are missing, and which have no other collision shape and no foot, their
/// inertia boxes at half their size; each is a warning. A body with weight at its ends, as an ankle with its motors,
/// has a box that reaches beyond it, into the ground or into the other leg, and what is guessed shall refuse no walk.
/// Boxes that are longer than the legs, which no link is, are left out, and so is what stands for part of a body: there
/// it is noted that nothing is known.
void TakeInertiaBoxes(const std::vector<MissingMesh>& missing, RobotModel& model);

}  // namespace gaitwright
