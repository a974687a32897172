// SPDX-License-Identifier: BSD-3-Clause
#include "planning/paths/plan_base_route.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "kinematics/collision/shape_extent.h"
#include "planning/paths/coarse_route.h"
#include "planning/paths/direct_route.h"
#include "planning/paths/pose_check.h"
#include "planning/paths/rrt_star.h"
#include "planning/paths/smooth_route.h"

namespace gaitwright {
namespace {

Failure Blocked(FailureCode code, const std::string& message, const std::vector<Suggestion>& suggestions) {
  return {FailureKind::kInfeasible, code, "PlanBaseRoute", message, suggestions};
}

TravelWeights WeightsOf(const BaseRouteOptions& options, const BodySpace& space) {
  return {options.lateral, options.backward, options.turn * space.leg_length_m};
}

void CheckPose(const char* name, const PlanarPose& pose) {
  for (const double value : {pose.x_m, pose.y_m, pose.yaw_rad}) {
    if (!std::isfinite(value))
      throw InvalidArgument(fmt::format("PlanBaseRoute: the {} contains {}; all numbers must be finite", name, value));
  }
}

/// The part of the plane in which a route may lie: everything on the terrain and some space around it, but not beyond
/// its ground, and without detours many times as long as the direct path.
PlaneExtent ExtentFor(const Terrain& terrain, const BodySpace& space, const PlanarPose& start, const PlanarPose& goal) {
  const Vector2 a(start.x_m, start.y_m), b(goal.x_m, goal.y_m);
  PlaneExtent ground, things;
  bool endless = false;
  for (const TerrainPatch& patch : terrain.patches) {
    endless = endless || patch.outline_T.empty();
    for (const Vector2& p : patch.outline_T)
      ground.extend(Vector2((patch.X_WT * Vector3(p.x(), p.y(), 0.0)).head<2>()));
  }
  for (const HeightField& field : terrain.height_fields) {
    ground.extend(field.origin_W);
    ground.extend(Vector2(field.origin_W + field.resolution_m * Vector2(field.columns - 1, field.rows - 1)));
  }
  for (const Obstacle& obstacle : terrain.obstacles) {
    const Vector2 middle = obstacle.X_WO.translation().head<2>();
    const double radius = BoundingRadius(ShapeOf(obstacle));
    things.extend(Vector2(middle.array() - radius));
    things.extend(Vector2(middle.array() + radius));
  }
  things.extend(ground);
  for (const Vector2& p : {a, b}) {
    things.extend(p);
    ground.extend(p);
  }
  const double around = 2.0 * space.radius_m + 2.0 * space.leg_length_m;
  const double farthest = 5.0 * (a - b).norm() + 20.0 * space.leg_length_m;
  const auto grown = [](PlaneExtent extent, double by) {
    return PlaneExtent(Vector2(extent.min().array() - by), Vector2(extent.max().array() + by));
  };
  PlaneExtent near;
  near.extend(a);
  near.extend(b);
  const PlaneExtent extent = grown(things, around).intersection(grown(near, farthest));
  return endless ? extent : extent.intersection(grown(ground, 1e-3));
}

/// Keeps the cheapest smoothed path of a search.
class Best {
 public:
  Best(PoseCheck& check, const TravelWeights& weights, SampleFocus& focus)
      : check_(check), weights_(weights), focus_(focus) {}

  /// Smoothing takes long, so only the first path is smoothed, and those that are clearly cheaper than the last
  /// smoothed one.
  void Take(const std::vector<PlanarPose>& path, double cost) {
    constexpr double kNotably = 0.95;
    last_ = cost;
    if (first_ == 0.0) first_ = cost;
    if (smoothed_ > 0.0 && cost > kNotably * smoothed_) return;
    smoothed_ = cost;
    std::vector<PlanarPose> smooth = SmoothRoute(check_, path, weights_);
    const double smooth_cost = TravelCost(smooth, weights_);
    if (first_smooth_ == 0.0) first_smooth_ = smooth_cost;
    if (smooth_cost >= cost_) return;
    cost_ = smooth_cost;
    route_ = std::move(smooth);
    focus_.cost = cost_;
    focus_.route = Densified(route_, {0.5 * check_.space().leg_length_m, 0.5});
  }

  bool found() const { return !route_.empty(); }
  const std::vector<PlanarPose>& route() const { return route_; }
  void Report(RouteStatistics& statistics) const {
    statistics.first_cost_m = first_;
    statistics.first_smooth_cost_m = first_smooth_;
    statistics.last_cost_m = last_;
  }

 private:
  PoseCheck& check_;
  TravelWeights weights_;
  SampleFocus& focus_;
  std::vector<PlanarPose> route_;
  double cost_ = std::numeric_limits<double>::infinity();
  double first_ = 0.0, first_smooth_ = 0.0, last_ = 0.0, smoothed_ = 0.0;
};

/// A free direct path that costs hardly more than the cheapest direct path; empty if none is free.
std::vector<PlanarPose> FreeDirectRoute(PoseCheck& check, const PlanarPose& start, const PlanarPose& goal,
                                        const BaseRouteOptions& options) {
  constexpr double kHardlyMore = 1.15;
  const auto routes = ByCost(start, goal, WeightsOf(options, check.space()));
  for (const auto& [cost, kind] : routes) {
    if (cost > kHardlyMore * routes.front().first) break;
    std::vector<PlanarPose> path = WaypointsOf(kind, start, goal, {options.spacing_m});
    if (check.IsFreeAlong(path)) return path;
  }
  return {};
}

std::string Summary(const BaseRoute& route) {
  const RouteStatistics& s = route.statistics;
  if (s.direct) return fmt::format("direct route of {:.2f} m", route.length_m);
  return fmt::format("route of {:.2f} m, cost {:.2f} m (first {:.2f} m), {} iterations, {} states, {} poses checked",
                     route.length_m, route.cost_m, s.first_smooth_cost_m, s.iterations, s.states, s.poses_checked);
}

BaseRoute RouteAlong(std::vector<PlanarPose> path, const BaseRouteOptions& options, const TravelWeights& weights) {
  BaseRoute route;
  route.waypoints = Densified(path, {options.spacing_m});
  if (route.waypoints.empty()) route.waypoints = std::move(path);
  route.length_m = LengthOf(route.waypoints);
  route.cost_m = TravelCost(route.waypoints, weights);
  return route;
}

/// A guide with at most about a third of the iterations: all its corners, and fewer poses between them.
std::vector<PlanarPose> Thinned(const std::vector<PlanarPose>& guide, int iterations) {
  const double most = std::max(1.0, iterations / 3.0);
  if (static_cast<double>(guide.size()) <= most) return guide;
  const double spacing_m = LengthOf(guide) / most;
  std::vector<PlanarPose> thin;
  for (std::size_t i = 0; i < guide.size(); ++i) {
    const bool corner = i == 0 || i + 1 == guide.size() || guide[i].yaw_rad != guide[i - 1].yaw_rad ||
                        guide[i].yaw_rad != guide[i + 1].yaw_rad;
    if (corner || std::hypot(guide[i].x_m - thin.back().x_m, guide[i].y_m - thin.back().y_m) >= spacing_m)
      thin.push_back(guide[i]);
  }
  return thin;
}

Failure NoRoute(const CoarseRoute& guide, const BaseRouteOptions& options, const RrtStarReport& report) {
  if (guide.complete) {
    return Blocked(FailureCode::kWayNotFound,
                   fmt::format("no route to the goal was found in {} iterations, although a coarse search finds one of "
                               "{:.1f} m; {} poses were reached",
                               report.iterations, LengthOf(guide.poses), report.states),
                   {fmt::format("raise footsteps.route.iterations (now {})", options.iterations)});
  }
  const std::string what = guide.hindrance ? "at its least blocked place, " + guide.hindrance->text
                                           : "the space between the obstacles is too narrow for the coarse search";
  return Blocked(
      FailureCode::kWayBlocked,
      fmt::format("start and goal are free, but all routes between them are blocked: {}; {} poses were reached", what,
                  report.states),
      {"move the goal or the obstacle"});
}

}  // namespace

Result<BaseRoute> PlanBaseRoute(const RobotModel& model, const Terrain& terrain, const PlanarPose& start,
                                const PlanarPose& goal, const BaseRouteOptions& options) {
  BaseRouteOptions checked = options;
  CheckOptions(checked.Fields());
  CheckPose("start", start);
  CheckPose("goal", goal);
  PoseCheck check(model, terrain, options.space);
  const TravelWeights weights = WeightsOf(options, check.space());
  if (const auto why = check.ReasonRefused(start))
    return Blocked(FailureCode::kStartBlocked, "the robot cannot stand at the start: " + why->text,
                   {"start at another place"});
  if (const auto why = check.ReasonRefused(goal))
    return Blocked(FailureCode::kGoalBlocked, "the robot cannot stand at the goal: " + why->text, {"move the goal"});
  BaseRoute route;
  RouteStatistics statistics;
  std::vector<PlanarPose> path = FreeDirectRoute(check, start, goal, options);
  statistics.direct = !path.empty();
  if (path.empty()) {
    const PlaneExtent extent = ExtentFor(terrain, check.space(), start, goal);
    const CoarseRoute guide = FindCoarseRoute(check, {start, goal, extent, weights});
    SampleFocus focus;
    Best best(check, weights, focus);
    RrtStarProblem problem{start, goal, extent, weights, options.iterations, static_cast<std::uint32_t>(options.seed),
                           {}};
    if (guide.complete) problem.guide = focus.route = Thinned(guide.poses, options.iterations);
    const RrtStarReport report =
        SearchRrtStar(check, problem, focus, [&](const auto& found, double cost) { best.Take(found, cost); });
    if (!best.found()) return NoRoute(guide, options, report);
    path = best.route();
    best.Report(statistics);
    statistics.iterations = report.iterations;
    statistics.states = report.states;
  }
  route = RouteAlong(std::move(path), options, weights);
  statistics.poses_checked = check.num_checks();
  route.statistics = statistics;
  route.summary = Summary(route);
  return route;
}

}  // namespace gaitwright
