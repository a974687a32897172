// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/base/data_shape.h"

namespace gaitwright {

/// Structure of a footstep file.
DataShape FootstepFileShape();

/// Structure of a file of column names.
DataShape ColumnNamesShape();

}  // namespace gaitwright
