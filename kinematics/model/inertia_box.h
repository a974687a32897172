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
/// has a box that is larger than the body and could reach into the ground or the other leg; half the size avoids that a
/// guess refuses a walk. Boxes longer than the legs are not plausible and left out, and so are boxes for a part of a
/// body; a note says that the shape is unknown.
void TakeInertiaBoxes(const std::vector<MissingMesh>& missing, RobotModel& model);

}  // namespace gaitwright
