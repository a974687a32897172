// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "kinematics/spatial/pose.h"

namespace gaitwright {

/// A vector function of the variables. `J` is null if the Jacobian is not needed; otherwise it has size value x
/// variables and must be filled.
using VectorFunction = std::function<void(const VectorX& x, VectorX& value, MatrixX* J)>;

/// A function from values only: the Jacobian is computed by central differences.
VectorFunction Differenced(std::function<void(const VectorX& x, VectorX& value)> function);

}  // namespace gaitwright
