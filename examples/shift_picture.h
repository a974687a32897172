// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "examples/zmp_demonstration.h"

namespace gaitwright::examples {

/// SVG picture with one plot for each shift: the zero-moment point, its value by the formula, the centre of mass and
/// the extent of the support over time, along one axis.
/// @param axis  0 for x, 1 for y.
std::string ShiftPicture(const std::vector<ShownShift>& shifts, int axis);

}  // namespace gaitwright::examples
