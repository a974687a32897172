// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "optimisation/pipeline/plan_motion.h"

namespace gaitwright {

/// The options with which a robot can be planned. One that cannot stand still (CanStandStill) has no pendulum whose
/// pressure moves between its feet: it is planned as a rigid body, and is on all feet for a moment at both ends.
MotionOptions OptionsOf(const RobotModel& model, MotionOptions options);

}  // namespace gaitwright
