// SPDX-License-Identifier: BSD-3-Clause
#include "planning/footsteps/plan_footsteps.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "kinematics/dynamics/foot_contact.h"
#include "kinematics/spatial/rotation.h"
#include "planning/footsteps/can_walk.h"
#include "planning/gait/schedule_contacts.h"
#include "planning/paths/base_path.h"

namespace gaitwright {
namespace {

Failure BadCommand(const std::string& message) {
  return {FailureKind::kBadInput, "command", "PlanFootsteps", message, {}};
}

std::optional<Failure> CheckCommand(const WalkCommand& c) {
  for (const double value : {c.speed_m_s, c.lateral_speed_m_s, c.yaw_rate_rad_s, c.distance_m, c.goal_x_m, c.goal_y_m,
                             c.goal_yaw_rad, c.step_length_m}) {
    if (!std::isfinite(value)) return BadCommand(fmt::format("the command holds {}; finite numbers are needed", value));
  }
  if (c.speed_m_s < 0.0) {
    return BadCommand(fmt::format(
        "the speed is {} m/s; it must not be negative; a goal behind makes the robot walk backward", c.speed_m_s));
  }
  if (c.extent == WalkCommand::Extent::kDistance && c.distance_m < 0.0)
    return BadCommand(fmt::format("the distance is {} m; it must not be negative", c.distance_m));
  if (c.extent == WalkCommand::Extent::kSteps && c.steps < 1)
    return BadCommand(fmt::format("{} steps are asked for; one or more are accepted", c.steps));
  if (std::abs(c.goal_yaw_rad) >= std::numbers::pi)
    return BadCommand(fmt::format("the goal's yaw is {} rad; it must lie between -pi and pi", c.goal_yaw_rad));
  return std::nullopt;
}

/// Where the base goes and how long it takes.
struct Course {
  PlanarTwist twist;
  double cruise_s = 1.0;  // at full speed
  bool operator==(const Course&) const = default;
};

/// Contact frames of the standing posture with the base origin at the origin.
std::vector<Pose> StandingFeet(const RobotModel& model) {
  DynamicsScratch scratch(model);
  ForwardKinematics(model, StandingConfiguration(model), scratch);
  std::vector<Pose> feet;
  for (int f = 0; f < static_cast<int>(model.feet.size()); ++f) {
    Pose X_BF = ContactFrame(model, scratch, f);
    X_BF.translation().z() = 0.0;
    feet.push_back(X_BF);
  }
  return feet;
}

/// Turning rate at which soles side by side, turned against each other by what a step turns, keep apart with a margin;
/// for feet without soles that at which they move no faster than the body's own speed.
double OwnTurnRate(const RobotModel& model, const Gait& gait, double speed) {
  constexpr double kShareOfGap = 0.7;
  double gap = std::numeric_limits<double>::infinity(), half_length = 0.0;
  const std::vector<Pose> standing = StandingFeet(model);
  for (std::size_t f = 0; f < model.feet.size(); ++f) {
    for (const Vector2& corner : model.feet[f].sole_F) {
      half_length = std::max(half_length, std::abs(corner.x()));
      gap = std::min(gap, 2.0 * (std::abs(standing[f].translation().y()) - std::abs(corner.y())));
    }
  }
  if (half_length == 0.0) return speed / (0.6 * model.leg_length_m());
  return kShareOfGap * std::max(gap, 0.0) / half_length / gait.cycle_s;
}

Course MakeCourse(const RobotModel& model, const Gait& gait, const WalkCommand& c) {
  const double speed = CommandedSpeed(model, c);
  if (c.extent == WalkCommand::Extent::kGoal) {
    const PlanarTwist twist = TwistTo({c.goal_x_m, c.goal_y_m, c.goal_yaw_rad});
    const double turn_rate = c.yaw_rate_rad_s != 0.0 ? std::abs(c.yaw_rate_rad_s) : OwnTurnRate(model, gait, speed);
    const double lateral = c.lateral_speed_m_s != 0.0 ? std::abs(c.lateral_speed_m_s) : 0.35 * speed;
    return {twist, std::max({std::abs(twist.x_m) / speed, std::abs(twist.y_m) / lateral,
                             std::abs(twist.yaw_rad) / turn_rate})};
  }
  if (c.extent == WalkCommand::Extent::kSteps) {
    return {{(c.steps - 1) * c.step_length_m, 0.0, 0.0}, c.steps * gait.cycle_s / gait.num_feet()};
  }
  const bool turns_only = c.speed_m_s == 0.0 && c.lateral_speed_m_s == 0.0 && c.yaw_rate_rad_s != 0.0;
  if (turns_only) {
    const double quarter = 0.5 * std::numbers::pi;
    return {{0.0, 0.0, std::copysign(quarter, c.yaw_rate_rad_s)}, quarter / std::abs(c.yaw_rate_rad_s)};
  }
  const double forward = c.lateral_speed_m_s == 0.0 ? speed : c.speed_m_s;
  const double duration = c.distance_m / std::hypot(forward, c.lateral_speed_m_s);
  return {{forward * duration, c.lateral_speed_m_s * duration, c.yaw_rate_rad_s * duration}, duration};
}

/// Why a course cannot be walked in one plan, however the legs are.
std::optional<Failure> CheckCourse(const Course& course) {
  constexpr double kLongest = 600.0;  // [s]
  if (!(course.cruise_s > 0.0)) return BadCommand("the command goes nowhere: it ends where it starts");
  if (course.cruise_s > kLongest) {
    return BadCommand(fmt::format("the walk would take {:.6g} s; at most {} s go into one plan: go less far or faster",
                                  course.cruise_s, kLongest));
  }
  return std::nullopt;
}

Pose Carried(const PlanarPose& base, const Pose& X_BF) {
  Pose X_WB = Pose::Identity();
  X_WB.linear() = YawRotation(base.yaw_rad);
  X_WB.translation() = Vector3(base.x_m, base.y_m, 0.0);
  return X_WB * X_BF;
}

/// Where the base counts for a foothold in the middle of its stance; with two feet the leading one looks half a cycle
/// ahead.
PlanarPose BaseForStance(const BasePath& path, const Foothold& foothold, const Pose& X_BF, const Gait& gait,
                         const PlanarTwist& twist) {
  const double middle = 0.5 * (foothold.touchdown_s + foothold.liftoff_s);
  PlanarPose base = PoseAt(path, middle);
  if (gait.num_feet() != 2) return base;
  const PlanarPose ahead = PoseAt(path, middle + 0.5 * gait.cycle_s);
  const double side = X_BF.translation().y();
  if (side * twist.yaw_rad > 0.0) base.yaw_rad = ahead.yaw_rad;
  if (side * twist.y_m > 0.0) {
    const double s = std::sin(base.yaw_rad), c = std::cos(base.yaw_rad);
    const double lateral = -s * (ahead.x_m - base.x_m) + c * (ahead.y_m - base.y_m);
    base.x_m -= s * lateral;
    base.y_m += c * lateral;
  }
  return base;
}

FootstepPlan PlaceFeet(const RobotModel& model, const Gait& gait, const WalkCommand& command, const PlanarTwist& twist,
                       const FootstepSkeleton& skeleton) {
  const std::vector<Pose> standing = StandingFeet(model);
  FootstepPlan plan;
  for (int f = 0; f < static_cast<int>(standing.size()); ++f) {
    const Pose& X_BF = standing[static_cast<std::size_t>(f)];
    const auto intervals = IntervalsOf(skeleton.schedule, f);
    for (std::size_t i = 0; i < intervals.size(); ++i) {
      Foothold foothold;
      foothold.foot = f;
      foothold.touchdown_s = intervals[i].start_s;
      foothold.liftoff_s = intervals[i].end_s;
      PlanarPose base = BaseForStance(skeleton.path, foothold, X_BF, gait, twist);
      if (i == 0) base = skeleton.path.pose.front();
      if (i + 1 == intervals.size()) base = skeleton.goal;
      foothold.X_WF = Carried(base, X_BF);
      plan.footholds.push_back(foothold);
    }
  }
  std::stable_sort(plan.footholds.begin(), plan.footholds.end(),
                   [](const Foothold& a, const Foothold& b) { return a.touchdown_s < b.touchdown_s; });
  if (command.extent == WalkCommand::Extent::kSteps && gait.num_feet() == 2) {
    // Footfall k lands k step lengths ahead, the last one beside the one before.
    int footfall = 0;
    for (Foothold& foothold : plan.footholds) {
      if (foothold.touchdown_s <= skeleton.schedule.start_s()) continue;
      ++footfall;
      const double x = std::min(footfall, command.steps - 1) * command.step_length_m;
      foothold.X_WF.translation().x() = standing[static_cast<std::size_t>(foothold.foot)].translation().x() + x;
    }
  }
  return plan;
}

/// The foothold farthest from its hip, against what the leg reaches.
struct Reach {
  int foothold = -1;
  double distance_m = 0.0, limit_m = 0.0, at_s = 0.0;
  double excess() const { return distance_m - limit_m; }
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
      if (distance - limit > worst.excess()) worst = {static_cast<int>(i), distance, limit, t};
    }
  }
  return worst;
}

Result<FootstepSkeleton> MakeSkeleton(const RobotModel& model, const Gait& gait, const WalkCommand& command,
                                      const FootstepOptions& options) {
  const Course course = MakeCourse(model, gait, command);
  if (const auto failure = CheckCourse(course)) return *failure;
  const double ramp = std::min(options.ramp_cycles * gait.cycle_s, course.cruise_s);
  const bool steps = command.extent == WalkCommand::Extent::kSteps;
  const double duration = steps ? course.cruise_s : course.cruise_s + ramp;
  ScheduleRequest request;
  request.initial_stand_s = options.initial_stand_s;
  request.final_stand_s = options.final_stand_s;
  request.stepping_s = std::ceil(duration / gait.cycle_s - 1e-6) * gait.cycle_s;
  request.footfalls = steps ? command.steps : 0;
  Result<ContactSchedule> schedule = ScheduleContacts(gait, request);
  if (!schedule) return schedule.failure();
  FootstepSkeleton skeleton;
  skeleton.schedule = std::move(*schedule);
  skeleton.path = MakeBasePath(course.twist, options.initial_stand_s, duration, ramp, skeleton.schedule.end_s());
  skeleton.goal = skeleton.path.pose.back();
  skeleton.footsteps = PlaceFeet(model, gait, command, course.twist, skeleton);
  return skeleton;
}

}  // namespace

double CommandedSpeed(const RobotModel& model, const WalkCommand& command) {
  return command.speed_m_s > 0.0 ? command.speed_m_s : model.nominal_speed_m_s;
}

double LargestSpeed(const RobotModel& model, const Gait& gait, const FootstepOptions& options) {
  double low = 0.0, high = 20.0;
  for (int i = 0; i < 30; ++i) {
    WalkCommand command;
    command.speed_m_s = 0.5 * (low + high);
    command.distance_m = 6.0 * command.speed_m_s * gait.cycle_s;
    const Result<FootstepSkeleton> skeleton = MakeSkeleton(model, gait, command, options);
    const bool reached = skeleton.ok() && WorstReach(model, *skeleton, options.reach).excess() <= 0.0;
    (reached ? low : high) = command.speed_m_s;
  }
  return low;
}

Result<FootstepSkeleton> PlanFootsteps(const RobotModel& model, const Terrain& terrain, const Gait& gait,
                                       const WalkCommand& command, const FootstepOptions& options) {
  if (const auto failure = CheckCommand(command)) return *failure;
  if (gait.num_feet() != static_cast<int>(model.feet.size())) {
    return BadCommand(fmt::format("gait '{}' is for {} feet; robot '{}' has {}", gait.name, gait.num_feet(), model.name,
                                  model.feet.size()));
  }
  if (auto cannot = WhyCannotWalk(model)) return *cannot;
  Result<FootstepSkeleton> skeleton = MakeSkeleton(model, gait, command, options);
  if (!skeleton) return skeleton;
  const Reach worst = WorstReach(model, *skeleton, options.reach);
  if (worst.excess() > 0.0) {
    const Foothold& foothold = skeleton->footsteps.footholds[static_cast<std::size_t>(worst.foothold)];
    const double largest = LargestSpeed(model, gait, options);
    return Failure{
        FailureKind::kInfeasible,
        "out_of_reach",
        "PlanFootsteps",
        fmt::format("foot '{}' cannot reach its foothold at {:.2f} s: it is {:.3f} m from its hip, the leg reaches "
                    "{:.3f} m; the largest speed with gait '{}' is {:.2f} m/s",
                    model.feet[static_cast<std::size_t>(foothold.foot)].name, worst.at_s, worst.distance_m,
                    worst.limit_m, gait.name, largest),
        {fmt::format("--speed {:.2f}", std::floor(100.0 * largest) / 100.0)}};
  }
  for (Foothold& foothold : skeleton->footsteps.footholds) {
    const GroundPoint ground = GroundAt(terrain, foothold.X_WF.translation().head<2>());
    foothold.patch = ground.patch;
    foothold.X_WF.translation().z() = ground.height_m;
  }
  return skeleton;
}

}  // namespace gaitwright
