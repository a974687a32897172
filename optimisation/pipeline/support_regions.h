// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/model/robot_model.h"
#include "optimisation/centroidal/zmp_problem.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// What SupportRegions needs beside robot, schedule and footholds.
struct SupportInputs {
  Vector2 start_W = Vector2::Zero(), end_W = Vector2::Zero();  ///< centre of mass at rest [m]
  double inward = 0.15;                                        ///< see SupportRegions
  double step_s = 0.005;
  std::vector<std::vector<Vector3>> contact_W;  ///< by foot, by sample [m]; may be empty
  std::vector<Polygon> support_F;  ///< by foothold, what carries it (SupportOf); the whole soles when empty
};

/// For each phase of the schedule, where the ZMP may be and where it is wanted; a phase on a line whose feet roll to
/// and fro is given in several parts. The region is the hull of what carries the soles in contact; the contact point of
/// a foot that rolls is taken from `contact_W`, an earlier solution's contact points by foot and sample of the grid, or
/// stands still when that is empty. Wanted: the middle of the region; under a single sole
/// that of the part in which its ankle holds the robot, moved by `inward` of the sole's width towards the body; where a
/// stance goes over into one that holds it, the point of the smaller counts for both; at the ends it is the centre of
/// mass at rest.
std::vector<ZmpPhase> SupportRegions(const RobotModel& model, const ContactSchedule& schedule,
                                     const FootstepPlan& footsteps, const SupportInputs& inputs);

}  // namespace gaitwright
