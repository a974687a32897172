// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/base/options.h"
#include "kinematics/base/result.h"
#include "planning/paths/body_space.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// Options of the route search.
///
/// Tuning
///   `way_not_found` where there is a way    more iterations
///   walks sideways or backward too much     more lateral, backward
///   stops to turn, or cuts corners askew    less or more turn
struct BaseRouteOptions {
  int iterations = 1000;
  int seed = 0;
  double lateral = 2.5;
  double backward = 1.5;
  double turn = 0.6;
  double spacing_m = 0.05;
  BodySpaceOptions space;

  OptionFields Fields() {
    return Joined(
        {WithBasics(
             {"iterations", "seed"},
             {{"iterations", &iterations, "1", 0.0, 1e6, "Number of RRT* samples if no direct route is free."},
              {"seed", &seed, "1", 0.0, 2147483647.0, "Random seed of the RRT* samples."},
              {"lateral", &lateral, "1", 1.0, 100.0, "Cost of a metre of lateral motion, in metres of forward motion."},
              {"backward", &backward, "1", 1.0, 100.0,
               "Cost of a metre of backward motion, in metres of forward motion."},
              {"turn", &turn, "leg lengths", 0.01, 100.0,
               "Cost of a radian of turning, as the equivalent forward distance."},
              {"spacing_m", &spacing_m, "m", 0.005, 0.5, "Longest distance between two waypoints."}}),
         Prefixed("space", space.Fields())});
  }
};

/// How a route was found.
struct RouteStatistics {
  bool direct = false;  ///< without a search
  int iterations = 0;   ///< of RRT*
  int states = 0;       ///< in its tree
  long poses_checked = 0;
  double first_cost_m = 0.0;         ///< of RRT*'s first solution before smoothing, and
  double first_smooth_cost_m = 0.0;  ///< smoothed
  double last_cost_m = 0.0;          ///< of its last solution before smoothing
};

/// A way of the base in plan view.
struct BaseRoute {
  std::vector<PlanarPose> waypoints;  ///< start to goal, to be interpolated linearly; yaws without jumps, so that the
                                      ///< last may be the goal's plus whole turns
  double length_m = 0.0;
  double cost_m = 0.0;  ///< see TravelCost
  RouteStatistics statistics;
  std::string summary;  ///< one line
};

/// A route of the base from start to goal on a terrain, free according to PoseCheck, with the body mostly facing along
/// the path. A free direct route is used if it costs hardly more than the cheapest; otherwise RRT*, each notable
/// improvement of which is smoothed, and the cheapest result: with one seed, more iterations never cost more. A pure
/// function of its arguments.
///
/// Failures, kInfeasible, each naming the obstacle or surface and the place:
///   `start_blocked`, `goal_blocked`  the robot cannot stand there
///   `way_blocked`                    nothing leads from one to the other; what is in the way where least is
///   `way_not_found`                  a coarse search finds a way, but the iterations did not
/// @throws InvalidArgument when an option or a pose is out of range or not finite.
Result<BaseRoute> PlanBaseRoute(const RobotModel& model, const Terrain& terrain, const PlanarPose& start,
                                const PlanarPose& goal, const BaseRouteOptions& options);

}  // namespace gaitwright
