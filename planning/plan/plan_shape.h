// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/base/data_shape.h"

namespace gaitwright {

/// Structure of a plan file.
DataShape PlanShape();
/// Structure of the list of adjustments (differences between plan and request).
DataShape AdjustmentsShape();

}  // namespace gaitwright
