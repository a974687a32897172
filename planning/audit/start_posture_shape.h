// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/base/data_shape.h"

namespace gaitwright {

/// What the file of a start posture may hold: joints by name.
DataShape StartPostureShape();

}  // namespace gaitwright
