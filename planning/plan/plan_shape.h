// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/base/data_shape.h"

namespace gaitwright {

/// Structure of a plan file.
DataShape PlanShape();
/// The list of adjustments: where a plan differs from the request.
DataShape AdjustmentsShape();

}  // namespace gaitwright
