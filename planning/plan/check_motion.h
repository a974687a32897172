// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// Columns of a whole-body trajectory that may be left out.
struct MotionColumns {
  bool torques = false, wrenches = false;
};

/// Whether a trajectory is one of this robot: one row or more of q, v and a, as many of each, and of the model's sizes;
/// torques and wrenches likewise, which may be absent altogether unless they are `needed`.
/// @throws InvalidArgument naming the column, how many there are and how many it takes.
void CheckMotion(const RobotModel& model, const WholeBodyTrajectory& motion, const MotionColumns& needed = {});

}  // namespace gaitwright
