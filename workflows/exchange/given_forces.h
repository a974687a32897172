// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "planning/plan/motion_plan.h"
#include "workflows/exchange/even_motion.h"

namespace gaitwright {

/// Replaces the derived torques and contact forces of a plan by those of a file.
///
/// Only forces given: torques follow from inverse dynamics; moments under soles minimise the residual of the motion.
/// Only torques given: the contact wrenches of the stance feet minimise the residual,
///   min |W (M a + h - S^T tau - sum_i J_i^T w_i)|^2,
/// where W scales forces by the robot's weight and moments by weight times leg length.
/// Both given: used as they are. `derived` describes the method.
void TakeGivenForces(const RobotModel& model, const EvenMotion& motion, MotionPlan& plan,
                     std::vector<DerivedPart>& derived);

}  // namespace gaitwright
