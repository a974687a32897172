// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/base/data_shape.h"

namespace gaitwright {

/// Structure of a terrain YAML file.
DataShape TerrainFileShape();

}  // namespace gaitwright
