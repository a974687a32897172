// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "kinematics/base/options.h"
#include "kinematics/base/result.h"
#include "kinematics/model/robot_model.h"
#include "planning/footsteps/foothold_check.h"
#include "planning/footsteps/footstep_route.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

class LegWorkspaces;

/// Limits, cost weights and budget of the search.
///
/// Tuning
///   finds nothing although a path exists     larger `max_expansions` or `offset`, smaller `reserve`
///   the feet stand too near to edges         larger `risk_weight`
///   the gait is uneven on easy ground        larger `phase_weight` and `departure_weight`
///   takes too long                           larger `bound`, smaller `improving_expansions`
struct FootstepSearchOptions {
  double step_length = 0.8;
  double step_height = 0.3;
  double leap_length = 1.6;
  double leap_height = 0.6;
  double reserve = 0.03;
  double offset = 0.25;
  double body_clearance = 0.05;
  double leg_clearance = 0.025;
  double sway = 0.5;
  double easy_sway = 0.75;
  double length_weight = 1.5;
  double phase_weight = 2.0;
  double departure_weight = 0.5;
  double height_weight = 0.5;
  double risk_weight = 0.3;
  double landing_weight = 2.0;
  double goal_tolerance = 0.15;
  double first_bound = 3.0;
  double bound = 1.05;
  int patience = 1000;
  int max_expansions = 20000;
  int improving_expansions = 200;
  /// Largest pitch of a sole about its front edge with which its leg reaches it [rad], for a planner that raises heels;
  /// 0: soles stay flat. PlanSequence uses it only where flat soles find no footholds.
  double heel_off_rad = 0.0;
  /// Kept by searches with the same robot that follow each other in one thread; null: each search has its own.
  std::shared_ptr<LegWorkspaces> workspaces = nullptr;

  OptionFields Fields();
};

/// A search problem: footfalls of a gait from standing at the start of a route to standing at its end.
struct FootstepQuery {
  Gait gait;
  FootstepRoute route;
  double stride_m = 0.0;  ///< distance in stations that the base moves in one cycle at full speed
  /// Whether the body may be at a pose of the base, with ground at a given height; empty allows all poses.
  std::function<bool(const PlanarPose& base, double ground_m)> body_free = {};
};

/// Feet that step together.
using Footfalls = std::vector<PlacedFoot>;

/// Statistics of a search.
struct FootstepSearchStats {
  int expanded = 0, generated = 0;
  int expanded_to_first = 0;  ///< number of expansions until the first solution
  int stances = 0;            ///< number of stances checked for reach and clearance
  double first_cost = 0.0;
  double cost = 0.0;   ///< cost of the result, roughly the number of group steps; see SearchFootsteps
  double bound = 0.0;  ///< no sequence of this graph costs less than cost / bound
};

/// Footfalls from standing to standing.
struct FootstepSequence {
  std::vector<PlacedFoot> start;  ///< by foot
  std::vector<Footfalls> steps;   ///< in the gait's order
  FootstepSearchStats stats;
};

/// The feet that lift off together, in the gait's order of lifting off.
std::vector<std::vector<int>> FootGroups(const Gait& gait);

/// Finds footfalls over uneven ground, for any number of feet, by an anytime search (ARA*) over stances. Its heuristic
/// weight starts at `first_bound` and is doubled after `patience` expansions without a solution. After the first
/// solution it is reduced again.
///
/// A state is a foothold of each foot and the group that steps next. For each foot and station of the route there are
/// few footholds: the foot's standing position under the base, points of a lattice around it, and the nearest point of
/// each surface near it. Each step of a group costs
///   mean over its feet of max(1, a / L) + length max(0, a / L - 1) + departure (d / offset)^2
///                         + height |dz| / leg + risk r,     plus phase (e + e^2), e = |lead - wanted| / L,
/// and, if all feet leap together, landing times the tilt of the base above them [rad]. Here a is the gain in stations,
/// L the stride, d the distance of the foot from its nominal position, and lead the distance of the group in front of
/// all other feet. The heuristic is the sum over groups of the mean over feet of max((end - station) / L, 1 if not at
/// the goal). It never exceeds the remaining cost and is consistent, so `stats.bound` holds for every sequence of these
/// footholds.
/// The robot can stand in a stance if all feet are within the workspace of their legs under the base fitted to the feet
/// (at the standing height or up to 15 % lower; with single soles also with the base moved above each of them by
/// `sway`), no two feet are crossed or nearer than their sizes, body, thighs and shanks are clear of the ground, and
/// the body is clear of obstacles. A swing is possible if no ground or obstacle on the straight line is higher above
/// either end than the feet can be lifted.
///
/// Failure kInfeasible: `no_footholds` names the place and the reason, with a hint if the expansions were used up.
/// kBadInput for a gait with another number of feet, or a route or stride of length zero. @throws InvalidArgument for
/// options out of range.
///
/// Likhachev, Gordon and Thrun, ARA*: Anytime A* with Provable Bounds on Sub-Optimality, NIPS 2003.
Result<FootstepSequence> SearchFootsteps(const RobotModel& model, const Terrain& terrain, const FootstepQuery& query,
                                         const FootholdOptions& footholds, const FootstepSearchOptions& options);

/// Whether SearchFootsteps finds a solution. Faster than that search if there is no solution.
bool FootstepsExist(const RobotModel& model, const Terrain& terrain, const FootstepQuery& query,
                    const FootholdOptions& footholds, const FootstepSearchOptions& options);

}  // namespace gaitwright
