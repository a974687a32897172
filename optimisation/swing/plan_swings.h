// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/base/options.h"
#include "kinematics/base/result.h"
#include "kinematics/model/robot_model.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

struct SwingOptions {
  double height_m = 0.0;
  double clearance_m = 0.0;

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
             {}}};
  }
};

/// One swing between each two successive footholds of a foot: the closed form first; where its sole comes nearer to the
/// ground in mid swing than the clearance asked, the lift is refined until it clears. Sorted by start time, then foot.
/// Failure kInfeasible names the foot and the time when no lift up to the leg's length clears.
Result<std::vector<SwingTrajectory>> PlanSwings(const RobotModel& model, const Terrain& terrain,
                                                const FootstepPlan& footsteps, const SwingOptions& options);

}  // namespace gaitwright
