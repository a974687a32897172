// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/base/data_shape.h"

namespace gaitwright {

/// What a file of footsteps may hold.
DataShape FootstepFileShape();

/// What a file of column names may hold.
DataShape ColumnNamesShape();

}  // namespace gaitwright
