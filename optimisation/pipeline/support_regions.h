// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/model/robot_model.h"
#include "optimisation/centroidal/zmp_problem.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// Inputs of SupportRegions in addition to robot, schedule and footholds.
struct SupportInputs {
  Vector2 start_W = Vector2::Zero(), end_W = Vector2::Zero();  ///< centre of mass at rest [m]
  double inward = 0.15;                                        ///< see SupportRegions
  double step_s = 0.005;
  std::vector<std::vector<Vector3>> contact_W;  ///< by foot, by sample [m]; may be empty
  std::vector<Polygon> support_F;  ///< by foothold, its supporting area (SupportOf); the whole soles if empty
};

/// The region and the preferred point of the ZMP for each phase of the schedule; a line phase whose feet roll back and
/// forth is divided into several parts. The region is the convex hull of the supporting areas of the soles in contact;
/// the contact point of a rolling foot comes from `contact_W` (contact points of an earlier solution, by foot and
/// sample), or is fixed if that is empty. The preferred point is the middle of the region; in single support, the
/// middle of the part in which the ankle can hold the robot, moved by `inward` of the sole's width towards the body; if
/// one stance contains the next, the point of the smaller applies to both; at the ends it is the centre of mass at
/// rest.
std::vector<ZmpPhase> SupportRegions(const RobotModel& model, const ContactSchedule& schedule,
                                     const FootstepPlan& footsteps, const SupportInputs& inputs);

}  // namespace gaitwright
