// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "examples/zmp_demonstration.h"

namespace gaitwright::examples {

/// The zero-moment point, what the formula gives for it, the centre of mass and the extent of the support over time
/// along one axis, a plot for each shift, as one SVG picture.
/// @param axis  0 for x, 1 for y.
std::string ShiftPicture(const std::vector<ShownShift>& shifts, int axis);

}  // namespace gaitwright::examples
