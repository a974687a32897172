// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/base/data_shape.h"

namespace gaitwright {

/// What a robot.yaml may hold.
DataShape RobotYamlShape();

}  // namespace gaitwright
