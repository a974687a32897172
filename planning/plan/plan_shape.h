// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/base/data_shape.h"

namespace gaitwright {

/// What a plan's file may hold.
DataShape PlanShape();

}  // namespace gaitwright
