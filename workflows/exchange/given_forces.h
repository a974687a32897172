// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "planning/plan/motion_plan.h"
#include "workflows/exchange/even_motion.h"

namespace gaitwright {

/// Replaces the derived torques and contact forces of a plan by those of a file.
///
/// Forces only: torques are those that the motion needs in addition; moments under soles minimise the unexplained part
/// of the motion. Torques only: contact wrenches of the stance feet that, with the torques, minimise the unexplained
/// part of the motion,
///   min |W (M a + h - S^T tau - sum_i J_i^T w_i)|^2,   W by the weight, and by weight times leg for moments.
/// Both: as given. The method is described in `derived`.
void TakeGivenForces(const RobotModel& model, const EvenMotion& motion, MotionPlan& plan,
                     std::vector<DerivedPart>& derived);

}  // namespace gaitwright
