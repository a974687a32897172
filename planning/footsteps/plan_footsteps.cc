// SPDX-License-Identifier: BSD-3-Clause
#include "planning/footsteps/plan_footsteps.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "kinematics/dynamics/dynamics.h"
#include "kinematics/spatial/rotation.h"
#include "planning/footsteps/can_walk.h"
#include "planning/footsteps/place_feet.h"
#include "planning/footsteps/route_of.h"
#include "planning/footsteps/uneven_footsteps.h"
#include "planning/gait/schedule_contacts.h"
#include "planning/paths/base_path.h"
#include "planning/paths/standing_feet.h"

namespace gaitwright {
namespace {

/// The foothold farthest from its hip, and the leg's reach.
struct Reach {
  int foothold = -1;
  double distance_m = 0.0, limit_m = 0.0, at_s = 0.0;
  double violation() const { return distance_m - limit_m; }
};

Reach WorstReach(const RobotModel& model, const FootstepSkeleton& skeleton, double share) {
  DynamicsScratch scratch(model);
  ForwardKinematics(model, StandingConfiguration(model), scratch);
  Reach worst;
  worst.distance_m = -1e9;
  for (std::size_t i = 0; i < skeleton.footsteps.footholds.size(); ++i) {
    const Foothold& foothold = skeleton.footsteps.footholds[i];
    const Leg& leg = model.legs[static_cast<std::size_t>(foothold.foot)];
    const Vector3 p_BH = scratch.p_WB[static_cast<std::size_t>(std::max(leg.hip_joint, leg.joints.front()) + 1)];
    const Foot& foot = model.feet[static_cast<std::size_t>(foothold.foot)];
    for (const double t : {foothold.touchdown_s, foothold.liftoff_s}) {
      Pose X_BH = Pose::Identity();
      X_BH.translation() = p_BH;
      const Vector3 hip = Carried(PoseAt(skeleton.path, t), X_BH).translation();
      const double distance = (foothold.X_WF.translation() - hip).norm();
      const double limit = share * (foot.sole_F.empty() ? leg.length_m : leg.length_m + 0.25 * leg.length_m);
      if (distance - limit > worst.violation()) worst = {static_cast<int>(i), distance, limit, t};
    }
  }
  return worst;
}

/// The path of the base for counted footfalls. Between its ramps, the base moves one step per footfall.
BasePath PathOfSteps(const PlanarTwist& step, int steps_to_goal, double footfall_s, const ContactSchedule& schedule) {
  if (schedule.phases.size() < 3) return MakeBasePath({}, 0.0, 1.0, 0.0, schedule.end_s());
  const double start = schedule.phases.front().end_s, duration = schedule.phases.back().start_s - start;
  const double ramp = std::clamp(duration - steps_to_goal * footfall_s, 0.0, 0.5 * duration);
  const double n = steps_to_goal;
  return MakeBasePath({n * step.x_m, n * step.y_m, n * step.yaw_rad}, start, duration, ramp, schedule.end_s());
}

std::string StandingStillNote(const WalkCommand& command, int num_feet) {
  return fmt::format("{} of {} feet take a step, so the walk ends where it starts; {} or more steps move the robot",
                     std::min(command.steps, num_feet), num_feet, num_feet);
}

Result<FootstepSkeleton> MakeSkeleton(const RobotModel& model, const Gait& gait, const WalkCommand& command,
                                      const FootstepOptions& options) {
  const Result<Course> course = MakeCourse(model, gait, command, options.ramp);
  if (!course) return course.failure();
  const bool counted = IsCounted(command);
  ScheduleRequest request;
  request.initial_stand_s = options.initial_stand_s + options.settling_s;
  request.final_stand_s = options.final_stand_s + options.settling_s;
  request.stepping_s = std::ceil(course->duration_s / gait.cycle_s - 1e-6) * gait.cycle_s;
  request.footfalls = counted ? command.steps : 0;
  request.first_foot = counted ? LeadingFoot(model, course->twist) : -1;
  request.grid_s = options.grid_s;
  Result<ContactSchedule> schedule = ScheduleContacts(gait, request);
  if (!schedule) return schedule.failure();
  FootstepSkeleton skeleton;
  skeleton.schedule = std::move(*schedule);
  if (counted) {
    CountedFootsteps placed = PlaceCounted(model, skeleton.schedule, course->twist);
    skeleton.footsteps = std::move(placed.footsteps);
    skeleton.path = PathOfSteps(course->twist, placed.steps_to_goal, gait.cycle_s / gait.num_feet(), skeleton.schedule);
    const bool moves = course->twist.x_m != 0.0 || course->twist.y_m != 0.0 || course->twist.yaw_rad != 0.0;
    if (moves && placed.steps_to_goal == 0) skeleton.warnings.push_back(StandingStillNote(command, gait.num_feet()));
  } else {
    skeleton.path = MakeBasePath(course->twist, request.initial_stand_s, course->duration_s, course->ramp_s,
                                 skeleton.schedule.end_s());
    skeleton.footsteps = PlaceAlongPath(model, gait, skeleton.schedule, skeleton.path, course->twist);
  }
  skeleton.goal = skeleton.path.pose.back();
  return skeleton;
}

bool Turns(const BasePath& path) {
  constexpr double kTurned = 1e-3;  // [rad]
  return std::any_of(path.pose.begin(), path.pose.end(), [&](const PlanarPose& pose) {
    return std::abs(pose.yaw_rad - path.pose.front().yaw_rad) > kTurned;
  });
}

/// Whether the path leaves the straight line along its first heading.
bool Sidesteps(const BasePath& path) {
  constexpr double kLateral = 1e-3;  // [m]
  const PlanarPose& first = path.pose.front();
  const Vector2 left(-std::sin(first.yaw_rad), std::cos(first.yaw_rad));
  return std::any_of(path.pose.begin(), path.pose.end(), [&](const PlanarPose& pose) {
    return std::abs(left.dot(Vector2(pose.x_m - first.x_m, pose.y_m - first.y_m))) > kLateral;
  });
}

/// The command, changed to the goal of a skeleton. SearchSkeleton may end beside the goal, with a warning.
WalkCommand AsReached(WalkCommand command, const FootstepSkeleton& skeleton) {
  if (skeleton.warnings.empty()) return command;
  const PlanarPose &from = skeleton.path.pose.front(), &to = skeleton.goal;
  const double c = std::cos(from.yaw_rad), s = std::sin(from.yaw_rad), x = to.x_m - from.x_m, y = to.y_m - from.y_m;
  if (command.extent == WalkCommand::Extent::kDistance) command.distance_m = std::hypot(x, y);
  if (command.extent == WalkCommand::Extent::kGoal) {
    command.goal_x_m = c * x + s * y;
    command.goal_y_m = c * y - s * x;
  }
  return command;
}

/// A skeleton with a single part. Fails if the robot cannot turn or step sideways as the skeleton needs.
Result<FootstepSkeleton> WithPart(const RobotModel& model, Result<FootstepSkeleton> skeleton, const Gait& gait,
                                  const WalkCommand& command) {
  if (!skeleton) return skeleton;
  if (Turns(skeleton->path)) {
    if (auto failure = ReasonCannotTurn(model)) return *failure;
  }
  if (Sidesteps(skeleton->path)) {
    if (auto failure = ReasonCannotSidestep(model)) return *failure;
  }
  skeleton->parts = {{gait, command, skeleton->goal, skeleton->schedule.start_s(), skeleton->schedule.end_s()}};
  return skeleton;
}

/// Footsteps over ground that is not level: along the command's own course, or along a route around obstacles. On
/// ground without obstacles, only the search for footholds decides where the robot can walk; a route is planned only
/// for a goal that cannot be reached straight.
Result<FootstepSkeleton> FindFootsteps(const RobotModel& model, const Terrain& terrain, const Gait& gait,
                                       const WalkCommand& command, const FootstepOptions& options) {
  const Result<FootstepQuery> query = CourseQuery(model, gait, command, options);
  if (!query) return query.failure();
  const Course course = *MakeCourse(model, gait, command, options.ramp);
  if (terrain.obstacles.empty()) {
    Result<FootstepSkeleton> straight = SearchSkeleton(model, terrain, *query, options);
    if (straight || command.extent != WalkCommand::Extent::kGoal) return straight;
    const Result<BaseRoute> route = RouteOf(model, terrain, command, course, options.route);
    if (!route || route->statistics.direct) return straight;
    return PlanFootstepsAlong(model, terrain, gait, command, route->waypoints, options);
  }
  const Result<BaseRoute> route = RouteOf(model, terrain, command, course, options.route);
  if (!route) return route.failure();
  if (!route->statistics.direct) return PlanFootstepsAlong(model, terrain, gait, command, route->waypoints, options);
  return SearchSkeleton(model, terrain, *query, options);
}

}  // namespace

std::optional<Failure> ReasonNotWalked(const RobotModel& model, const Gait& gait, const WalkCommand& command) {
  if (auto failure = CheckCommand(command)) return failure;
  if (gait.num_feet() != static_cast<int>(model.feet.size())) {
    return Failure{FailureKind::kBadInput,
                   FailureCode::kCommand,
                   "PlanFootsteps",
                   fmt::format("gait '{}' is for {} feet; robot '{}' has {}", gait.name, gait.num_feet(), model.name,
                               model.feet.size()),
                   {}};
  }
  return ReasonCannotWalk(model);
}

std::optional<Failure> ReasonOutOfReach(const RobotModel& model, const FootstepSkeleton& skeleton, double share) {
  const Reach worst = WorstReach(model, skeleton, share);
  if (!(worst.violation() > 0.0)) return std::nullopt;
  const Foothold& foothold = skeleton.footsteps.footholds[static_cast<std::size_t>(worst.foothold)];
  return Failure{
      FailureKind::kInfeasible,
      FailureCode::kFootholdOutOfReach,
      "PlanFootsteps",
      fmt::format(
          "foot '{}' cannot reach its foothold at {:.2f} s: it is {:.3f} m from its hip, but the leg reaches {:.3f} m",
          model.feet[static_cast<std::size_t>(foothold.foot)].name, worst.at_s, worst.distance_m, worst.limit_m),
      {"lower the speed or the step length"}};
}

void PutOnGround(const Terrain& terrain, FootstepPlan& footsteps) {
  for (Foothold& foothold : footsteps.footholds) {
    const GroundPoint ground = GroundAt(terrain, foothold.X_WF.translation().head<2>());
    foothold.patch = ground.patch;
    foothold.X_WF.translation().z() = ground.height_m;
    foothold.X_WF.linear() = RotationBetween(Vector3::UnitZ(), ground.normal_W) * foothold.X_WF.linear();
  }
}

Result<FootstepSkeleton> PlanFootstepsAlong(const RobotModel& model, const Terrain& terrain, const Gait& gait,
                                            const WalkCommand& command, const std::vector<PlanarPose>& poses,
                                            const FootstepOptions& options) {
  if (auto failure = ReasonNotWalked(model, gait, command)) return *failure;
  const PlanarTwist speed = FittingSpeeds(model, gait, command);
  const FootstepQuery query{gait, RouteThrough(poses, {speed.x_m, speed.y_m, speed.yaw_rad}), speed.x_m * gait.cycle_s};
  const Result<FootstepSkeleton> found = SearchSkeleton(model, terrain, query, options);
  return WithPart(model, found, gait, found ? AsReached(command, *found) : command);
}

Result<FootstepSkeleton> PlanFootsteps(const RobotModel& model, const Terrain& terrain, const Gait& gait,
                                       const WalkCommand& command, const FootstepOptions& options) {
  if (auto failure = ReasonNotWalked(model, gait, command)) return *failure;
  if (KindOfGround(terrain) != GroundKind::kFlat) {
    const Result<FootstepSkeleton> found = FindFootsteps(model, terrain, gait, command, options);
    return WithPart(model, found, gait, found ? AsReached(command, *found) : command);
  }
  Result<FootstepSkeleton> skeleton = MakeSkeleton(model, gait, command, options);
  if (!skeleton) return skeleton;
  if (auto failure = ReasonOutOfReach(model, *skeleton, options.reach)) return *failure;
  PutOnGround(terrain, skeleton->footsteps);
  return WithPart(model, std::move(skeleton), gait, command);
}

}  // namespace gaitwright
