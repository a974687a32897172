// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// Inertia of solids of the same density with the total mass `mass` [kg], about their common centre of mass, in the
/// axes of frame B of their poses X_BS [kg m^2]. A mesh counts as its bounding box, and overlapping volumes count
/// twice. Nothing if there is no shape with a volume.
std::optional<Matrix3> SolidInertia(const std::vector<const Shape*>& shapes, double mass);

}  // namespace gaitwright
