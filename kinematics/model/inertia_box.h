// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// The box of uniform density with the mass and inertia of a body, at its centre of mass and along its principal axes.
/// Nothing if the body has no mass or no inertia.
std::optional<Shape> InertiaBox(const RobotModel& model, int body);

/// Adds an inertia box at half its size to each body whose collision meshes are missing and that has no other collision
/// shape and no foot; each box is a warning. A body with mass at its ends, such as an ankle with motors, has a box that
/// is larger than the body and could reach into the ground or the other leg. Half the size avoids that a guess refuses
/// a walk. Boxes longer than the legs are not plausible and are left out, and so are boxes for a part of a body; a
/// finding then reports that contacts of the link are not checked.
void TakeInertiaBoxes(const std::vector<MissingMesh>& missing, RobotModel& model);

}  // namespace gaitwright
