// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// Optional columns of a whole-body trajectory that a caller needs.
struct MotionColumns {
  bool torques = false, wrenches = false;
};

/// Checks that a trajectory fits a robot: q, v and a have the same number of rows, at least one, each of the model's
/// size. The same holds for torques and wrenches; these may be empty unless they are `needed`.
/// @throws InvalidArgument that names the column, its size and the size needed.
void CheckMotion(const RobotModel& model, const WholeBodyTrajectory& motion, const MotionColumns& needed = {});

}  // namespace gaitwright
