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
///   `way_not_found` although a route exists  more iterations
///   walks sideways or backward too much      larger lateral, backward
///   stops to turn                            larger turn
///   walks askew around corners               smaller turn
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
  bool direct = false;  ///< a direct route, without a search
  int iterations = 0;   ///< number of RRT* iterations
  int states = 0;       ///< number of states in the tree
  long poses_checked = 0;
  double first_cost_m = 0.0;         ///< cost of the first RRT* solution before smoothing
  double first_smooth_cost_m = 0.0;  ///< cost of the first RRT* solution after smoothing
  double last_cost_m = 0.0;          ///< cost of the last RRT* solution before smoothing
};

/// A route of the base in plan view.
struct BaseRoute {
  std::vector<PlanarPose> waypoints;  ///< start to goal, to be interpolated linearly; yaws without jumps, so that the
                                      ///< last may be the goal's plus whole turns
  double length_m = 0.0;
  double cost_m = 0.0;  ///< see TravelCost
  RouteStatistics statistics;
  std::string summary;  ///< one line
};

/// A route of the base from start to goal on a terrain. It is free according to PoseCheck, and the body mostly faces
/// along the path. A free direct route is used if it costs hardly more than the cheapest one. Otherwise RRT* is used:
/// each notable improvement is smoothed, and the cheapest result is returned. For a given seed, more iterations never
/// increase the cost. Deterministic: the result depends on the arguments only.
///
/// Failures, kInfeasible, each naming the obstacle or surface and the place:
///   `start_blocked`, `goal_blocked`  the robot cannot stand there
///   `way_blocked`                    no route exists; names the obstacle at the least blocked place
///   `way_not_found`                  the coarse search finds a route, but RRT* did not within its iterations
/// @throws InvalidArgument for an option or a pose that is out of range or not finite.
Result<BaseRoute> PlanBaseRoute(const RobotModel& model, const Terrain& terrain, const PlanarPose& start,
                                const PlanarPose& goal, const BaseRouteOptions& options);

}  // namespace gaitwright
