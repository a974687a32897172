// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/base/options.h"
#include "kinematics/base/result.h"
#include "kinematics/model/robot_model.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// How a walk begins and ends, and how far a foot may go.
struct FootstepOptions {
  double initial_stand_s = 0.8;
  double final_stand_s = 0.8;
  double ramp_cycles = 1.0;
  double reach = 0.97;

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
/// A foothold stands where its foot stands in the standing posture, carried along by the base to where it is at the
/// middle of the stance (Raibert's symmetric placement, Legged Robots That Balance, 1986); first and last footholds are
/// those of standing at the start and at the goal. With two feet the one on the side of a side-step or turn leads by
/// half a cycle, so that the feet are kept apart. Failures: kBadInput for a command that makes no
/// sense, goes nowhere or takes over 600 s; kInfeasible for gaits with flight, a speed that no leg can reach (names the
/// largest that can), a foothold out of reach (names foot, time and distance).
Result<FootstepSkeleton> PlanFootsteps(const RobotModel& model, const Terrain& terrain, const Gait& gait,
                                       const WalkCommand& command, const FootstepOptions& options);

/// Speed of the command along its direction that is used: given, or the robot's own.
double CommandedSpeed(const RobotModel& model, const WalkCommand& command);

/// Largest speed at which every foot finds its foothold within reach at this gait, found by bisection [m/s].
double LargestSpeed(const RobotModel& model, const Gait& gait, const FootstepOptions& options);

}  // namespace gaitwright
