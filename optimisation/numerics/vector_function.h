// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "kinematics/spatial/pose.h"

namespace gaitwright {

/// A vector function of the variables. `J` is null when it is not wanted; else size value x variables, to be filled.
using VectorFunction = std::function<void(const VectorX& x, VectorX& value, MatrixX* J)>;

/// A function given by its values alone: the Jacobian by central differences.
VectorFunction Differenced(std::function<void(const VectorX& x, VectorX& value)> function);

}  // namespace gaitwright
