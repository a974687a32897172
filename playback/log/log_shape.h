// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/base/data_shape.h"

namespace gaitwright {

/// What a log's file may hold.
DataShape LogShape();

}  // namespace gaitwright
