// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/base/options.h"
#include "kinematics/base/result.h"
#include "kinematics/model/robot_model.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// How high feet are lifted, and how a detour is sought where that is not enough.
struct SwingOptions {
  double height_m = 0.0;
  double clearance_m = 0.0;
  int control_points = 12;
  int samples = 30;

  OptionFields Fields() {
    return {{"height_m",
             &height_m,
             "m",
             0.0,
             1.0,
             "Lift of the foot over the straight line between its footholds; 0 takes 0.12 of the leg length.",
             {}},
            {"clearance_m",
             &clearance_m,
             "m",
             0.0,
             0.5,
             "Least height of the whole sole over the ground in mid swing; 0 takes a quarter of the lift.",
             {}},
            {"control_points", &control_points, "1", 9, 14, "Control points of a swing that takes a detour.", {}},
            {"samples", &samples, "1", 20, 40, "Places of such a swing at which its clearance is asked for.", {}}};
  }
};

/// One swing between each two successive footholds of a foot: the closed form first; where its underside comes nearer
/// to the ground than the clearance asked (less towards both ends, see ClearanceRamp), RefineSwing finds a detour, and
/// where that finds none, the lift is raised until it clears. Sorted by start time, then foot. Failure kInfeasible
/// names the foot and the time when no lift up to the leg's length clears.
Result<std::vector<SwingTrajectory>> PlanSwings(const RobotModel& model, const Terrain& terrain,
                                                const FootstepPlan& footsteps, const SwingOptions& options);

}  // namespace gaitwright
