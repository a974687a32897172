// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/base/data_shape.h"

namespace gaitwright {

/// What the YAML of a ground may hold.
DataShape TerrainFileShape();

}  // namespace gaitwright
