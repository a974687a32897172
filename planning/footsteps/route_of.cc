// SPDX-License-Identifier: BSD-3-Clause
#include "planning/footsteps/route_of.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "planning/paths/pose_check.h"
#include "planning/paths/travel_cost.h"

namespace gaitwright {
namespace {

/// Poses along the whole course, with at most the given spacing.
std::vector<PlanarPose> PosesAlong(const WalkCommand& command, const Course& course, double spacing_m) {
  constexpr double kTurn = 0.1;  // [rad] between poses
  const double count = IsCounted(command) ? command.steps : 1.0;
  const PlanarTwist& twist = course.twist;
  const double length = count * std::hypot(twist.x_m, twist.y_m), turn = count * std::abs(twist.yaw_rad);
  const int n = std::max(1, static_cast<int>(std::ceil(std::max(length / spacing_m, turn / kTurn))));
  std::vector<PlanarPose> poses;
  for (int k = 0; k <= n; ++k) poses.push_back(PoseAlong(twist, count * k / n));
  return poses;
}

/// The first pose along a path that is not free.
struct FirstBlocked {
  std::size_t before = 0;  ///< index of the waypoint after it; poses.size() if all are free
  Hindrance hindrance;
};

std::optional<FirstBlocked> FindBlocked(PoseCheck& check, const std::vector<PlanarPose>& poses) {
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (auto why = check.ReasonRefused(poses[i])) return FirstBlocked{i, *why};
    if (i + 1 == poses.size() || check.IsFreeBetween(poses[i], poses[i + 1])) continue;
    constexpr int kBetween = 16;
    for (int k = 1; k <= kBetween; ++k) {
      if (auto why = check.ReasonRefused(Between(poses[i], poses[i + 1], static_cast<double>(k) / kBetween)))
        return FirstBlocked{i + 1, *why};
    }
  }
  return std::nullopt;
}

Failure Refused(const std::vector<PlanarPose>& poses, const FirstBlocked& blocked) {
  if (blocked.before == 0)
    return {FailureKind::kInfeasible,
            FailureCode::kStartBlocked,
            "RouteOf",
            "the robot cannot stand at the start: " + blocked.hindrance.text,
            {"start at another place"}};
  const std::vector<PlanarPose> free(poses.begin(), poses.begin() + static_cast<std::ptrdiff_t>(blocked.before));
  return {FailureKind::kInfeasible,
          FailureCode::kWayBlocked,
          "RouteOf",
          fmt::format("the path is blocked after {:.2f} of {:.2f} m: {}", LengthOf(free), LengthOf(poses),
                      blocked.hindrance.text),
          {"give a goal (--goal), which the robot reaches around obstacles", "reduce the distance"}};
}

BaseRoute AlongCourse(const RobotModel& model, std::vector<PlanarPose> poses, const BaseRouteOptions& options) {
  BaseRoute route;
  route.length_m = LengthOf(poses);
  route.cost_m = TravelCost(poses, {options.lateral, options.backward, options.turn * model.leg_length_m()});
  route.statistics.direct = true;
  route.summary = fmt::format("direct route of {:.2f} m", route.length_m);
  route.waypoints = std::move(poses);
  return route;
}

}  // namespace

Result<BaseRoute> RouteOf(const RobotModel& model, const Terrain& terrain, const WalkCommand& command,
                          const Course& course, const BaseRouteOptions& options) {
  PoseCheck check(model, terrain, options.space);
  std::vector<PlanarPose> poses = PosesAlong(command, course, options.spacing_m);
  const auto blocked = FindBlocked(check, poses);
  if (!blocked) return AlongCourse(model, std::move(poses), options);
  if (command.extent != WalkCommand::Extent::kGoal) return Refused(poses, *blocked);
  Result<BaseRoute> route =
      PlanBaseRoute(model, terrain, {}, {command.goal_x_m, command.goal_y_m, command.goal_yaw_rad}, options);
  if (route) route->statistics.direct = false;  // even if it is a direct route of another kind
  return route;
}

}  // namespace gaitwright
