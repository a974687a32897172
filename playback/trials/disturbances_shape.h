// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/base/data_shape.h"

namespace gaitwright {

/// What a file of disturbances may hold, each figure as a value or a distribution.
/// @param sensors  as of ReadDisturbances
DataShape DisturbancesShape(const OptionFields& sensors);

}  // namespace gaitwright
