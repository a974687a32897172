// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/base/data_shape.h"

namespace gaitwright {

/// Structure of a disturbance file, with each quantity as a value or a distribution.
/// @param sensors  as in ReadDisturbances
DataShape DisturbancesShape(const OptionFields& sensors);

}  // namespace gaitwright
