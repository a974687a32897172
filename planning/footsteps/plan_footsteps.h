// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/base/options.h"
#include "kinematics/base/result.h"
#include "kinematics/model/robot_model.h"
#include "planning/footsteps/course.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// How a walk begins and ends, and how far a foot may go.
struct FootstepOptions {
  double initial_stand_s = 0.8;
  double final_stand_s = 0.8;
  double ramp_cycles = 1.0;
  double reach = 0.97;
  double grid_s = 0.005;  ///< step of the plan's grid, on which contacts begin and end; the pipeline sets it

  OptionFields Fields() {
    return {{"initial_stand_s", &initial_stand_s, "s", 0.1, 10.0, "Time on all feet before the first step.", {}},
            {"final_stand_s", &final_stand_s, "s", 0.1, 10.0, "Time on all feet after the last step.", {}},
            {"ramp_cycles", &ramp_cycles, "1", 0.0, 10.0, "Cycles in which the base gains its speed and loses it.", {}},
            {"reach",
             &reach,
             "1",
             0.5,
             1.0,
             "Farthest that a foothold may be from its hip, as a share of the straight leg.",
             {}}};
  }
};

/// What is settled before motion is continuous.
struct FootstepSkeleton {
  BasePath path;
  ContactSchedule schedule;
  FootstepPlan footsteps;
  PlanarPose goal;
  std::vector<std::string> warnings;
};

/// Base path, contact schedule and footholds on level ground for a command.
///
/// Footholds follow the base along its path (PlaceAlongPath), or a command of counted footfalls (PlaceCounted).
/// Failures: kBadInput for a command that makes no sense, contradicts itself, goes nowhere or takes over 600 s, and for
/// a gait too fast for the grid; kInfeasible for gaits with flight and for a foothold out of reach (names foot, time
/// and distance).
Result<FootstepSkeleton> PlanFootsteps(const RobotModel& model, const Terrain& terrain, const Gait& gait,
                                       const WalkCommand& command, const FootstepOptions& options);

}  // namespace gaitwright
