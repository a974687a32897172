// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/model/robot_model.h"
#include "planning/plan/motion_plan.h"
#include "playback/policy/fit_policy_internal.h"

namespace gaitwright {

/// The command of a policy as a plan, so that a policy is played, tried and reported like a plan. Its contact schedule
/// is empty, which says that it plans no contacts (PlansContacts): its rows hold only the contract's default posture,
/// with a base that moves at the commanded velocity. It has no torques, forces or footholds.
///
/// The robot starts with its feet on the ground at the origin of W, facing x. In the default posture its feet may not
/// be level; the base is then rotated so that they are, up to 0.2 rad.
/// @param duration_s  above 0 and up to an hour.
/// @throws InvalidArgument for another duration, and for a ground without a surface at the origin.
MotionPlan CommandedPlan(const RobotModel& model, const FittedPolicy& policy, const Terrain& terrain,
                         double duration_s);

/// The configuration in which the policy starts on level ground at height 0.
VectorX StartOfPolicy(const RobotModel& model, const FittedPolicy& policy);

/// Largest distance of a foot's contact point above the lowest one in StartOfPolicy [m].
double UnevenFeet(const RobotModel& model, const FittedPolicy& policy);

}  // namespace gaitwright
