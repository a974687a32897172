// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "kinematics/base/options.h"
#include "kinematics/base/result.h"
#include "kinematics/model/robot_model.h"
#include "planning/footsteps/course.h"
#include "planning/footsteps/foothold_check.h"
#include "planning/footsteps/search_footsteps.h"
#include "planning/paths/plan_base_route.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// Start and end of a walk, reach of the feet, and for uneven ground the foothold rules and the search.
struct FootstepOptions {
  double initial_stand_s = 0.8;
  double final_stand_s = 0.8;
  SpeedRamp ramp = {1.0, 1.0};
  double reach = 0.97;
  double grid_s = 0.005;    ///< time step of the plan, on which contacts begin and end; set by the pipeline
  double settling_s = 0.0;  ///< additional standing time at both ends; set by the pipeline
  FootholdOptions foothold;
  FootstepSearchOptions search;
  BaseRouteOptions route;

  OptionFields Fields() {
    return Joined({OwnFields(), Prefixed("foothold", foothold.Fields()), Prefixed("search", search.Fields()),
                   Prefixed("route", route.Fields())});
  }

 private:
  OptionFields OwnFields() {
    return WithBasics({"initial_stand_s", "final_stand_s"},
                      {{"initial_stand_s", &initial_stand_s, "s", 0.1, 10.0,
                        "Time that the robot stands on all feet before the first step."},
                       {"final_stand_s", &final_stand_s, "s", 0.1, 10.0,
                        "Time that the robot stands on all feet after the last step."},
                       {"ramp_cycles", &ramp.cycles, "1", 0.0, 10.0,
                        "Smallest number of gait cycles over which the base speeds up, and over which it slows down."},
                       {"ramp_acceleration", &ramp.acceleration_m_s2, "m/s^2", 0.0, 100.0,
                        "Largest acceleration of the base when it speeds up or slows down; 0 sets no limit."},
                       {"reach", &reach, "1", 0.5, 1.0,
                        "Largest distance of a foothold from its hip, as a share of the straight leg's length."}});
  }
};

/// Discrete part of a plan, before the continuous motion.
struct FootstepSkeleton {
  BasePath path;
  ContactSchedule schedule;
  FootstepPlan footsteps;
  PlanarPose goal;
  std::vector<MotionPart> parts;
  std::vector<std::string> warnings;
  FootstepSearchStats search;  ///< all zero on level ground, where no search is needed
};

/// Base path, contact schedule and footholds for a command.
///
/// On infinite level ground without obstacles, footholds follow the base along its path (PlaceAlongPath), or a command
/// of counted footfalls (PlaceCounted). On other ground, the command's course in plan view is the route of a search
/// (SearchFootsteps); a goal without a free direct path is reached around obstacles (RouteOf). The search aims at steps
/// of the gait's stride at the commanded speed and uses as many footfalls as needed, also for a command with a duration
/// or a number of steps. Failures: kBadInput for a command that is invalid, contradictory, without motion or longer
/// than 600 s, and for a gait too fast for the grid; kInfeasible for a foothold out of reach (names foot, time and
/// distance), and if no footholds are found (names place and reason).
Result<FootstepSkeleton> PlanFootsteps(const RobotModel& model, const Terrain& terrain, const Gait& gait,
                                       const WalkCommand& command, const FootstepOptions& options);

/// PlanFootsteps along a given path of the base, for example around obstacles. The command only gives the speeds.
/// @param poses  in plan view from (0, 0, 0) on, dense enough for straight lines between them.
Result<FootstepSkeleton> PlanFootstepsAlong(const RobotModel& model, const Terrain& terrain, const Gait& gait,
                                            const WalkCommand& command, const std::vector<PlanarPose>& poses,
                                            const FootstepOptions& options);

/// Failure if a foothold is out of reach of its leg: names the worst foot, the time and the distance.
std::optional<Failure> ReasonOutOfReach(const RobotModel& model, const FootstepSkeleton& skeleton, double share);

/// Moves footholds planned on the level plane z = 0 onto the ground of `terrain`.
void PutOnGround(const Terrain& terrain, FootstepPlan& footsteps);

/// Failure if a command or a gait is invalid for every robot, or for this one.
std::optional<Failure> ReasonNotWalked(const RobotModel& model, const Gait& gait, const WalkCommand& command);

}  // namespace gaitwright
