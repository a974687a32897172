// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "planning/plan/motion_plan.h"
#include "workflows/exchange/even_motion.h"

namespace gaitwright {

/// Puts the torques and contact forces that a file has into the plan of its motion, in place of those that were worked
/// out there.
///
/// Forces alone: torques are what the motion needs beside them; the moments under soles are those that leave least of
/// the motion without cause. Torques alone: the contact wrenches of the feet that stand which together with them leave
/// least of the motion without cause,
///   min |W (M a + h - S^T tau - sum_i J_i^T w_i)|^2,   W by the weight, and by weight times leg for moments.
/// Both: as they are. What is done is said in `derived`.
void TakeGivenForces(const RobotModel& model, const EvenMotion& motion, MotionPlan& plan,
                     std::vector<DerivedPart>& derived);

}  // namespace gaitwright
