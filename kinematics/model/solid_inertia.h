// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// Inertia of solids of one density that together weigh `mass` [kg], about their common centre of mass, in the axes of
/// the frame that their poses X_BS are in [kg m^2]; a mesh counts as the box around it, and what overlaps counts twice.
/// Nothing where there is no shape.
std::optional<Matrix3> SolidInertia(const std::vector<const Shape*>& shapes, double mass);

}  // namespace gaitwright
