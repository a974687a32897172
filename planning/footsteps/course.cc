// SPDX-License-Identifier: BSD-3-Clause
#include "planning/footsteps/course.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "planning/footsteps/uneven_footsteps.h"
#include "planning/paths/standing_feet.h"

namespace gaitwright {
namespace {

using Extent = WalkCommand::Extent;

Failure BadCommand(const std::string& message) {
  return {FailureKind::kBadInput, FailureCode::kCommand, "PlanFootsteps", message, {}};
}

PlanarTwist Scaled(const PlanarTwist& twist, double factor) {
  return {factor * twist.x_m, factor * twist.y_m, factor * twist.yaw_rad};
}

/// Default yaw rate. For soles: neighbouring soles, rotated against each other by the turn of one step, keep a margin.
/// For feet without soles: the feet move no faster than the body's own speed.
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

/// The course to a pose; duration_s is the time at full speed.
Course ToGoal(const RobotModel& model, const Gait& gait, const WalkCommand& c) {
  const PlanarTwist twist = TwistTo({c.goal_x_m, c.goal_y_m, c.goal_yaw_rad});
  const PlanarTwist speed = FittingSpeeds(model, gait, c);
  return {twist,
          std::max({std::abs(twist.x_m) / speed.x_m, std::abs(twist.y_m) / speed.y_m,
                    std::abs(twist.yaw_rad) / speed.yaw_rad}),
          0.0};
}

/// The course along the commanded velocity; duration_s is the time at full speed.
Course AlongDistance(const RobotModel& model, const WalkCommand& c) {
  const PlanarTwist velocity = CommandedVelocity(model, c);
  const double speed = std::hypot(velocity.x_m, velocity.y_m);
  const double time = speed > 0.0 ? c.distance_m / speed : 0.5 * std::numbers::pi / std::abs(velocity.yaw_rad);
  return {Scaled(velocity, time), time, 0.0};
}

double RampTime(const RobotModel& model, const Gait& gait, const WalkCommand& c, const SpeedRamp& ramp) {
  const PlanarTwist velocity = CommandedVelocity(model, c);
  const double speed = std::hypot(velocity.x_m, velocity.y_m);
  return std::max(ramp.cycles * gait.cycle_s, ramp.acceleration_m_s2 > 0.0 ? speed / ramp.acceleration_m_s2 : 0.0);
}

Course ForDuration(const RobotModel& model, const Gait& gait, const WalkCommand& c, const SpeedRamp& ramp) {
  const double duration = std::max(1.0, std::round(c.duration_s / gait.cycle_s)) * gait.cycle_s;
  const double ramp_s = std::min(RampTime(model, gait, c, ramp), 0.5 * duration);
  return {Scaled(CommandedVelocity(model, c), duration - ramp_s), duration, ramp_s};
}

Course OfSteps(const RobotModel& model, const Gait& gait, const WalkCommand& c) {
  const double footfall_s = gait.cycle_s / gait.num_feet();
  if (c.extent == Extent::kGoal) {
    const PlanarTwist twist = TwistTo({c.goal_x_m, c.goal_y_m, c.goal_yaw_rad});
    return {Scaled(twist, 1.0 / std::max(1, StepsOfBase(gait, c.steps))), c.steps * footfall_s, 0.0};
  }
  PlanarTwist step = Scaled(CommandedVelocity(model, c), footfall_s);
  if (c.speed_m_s == 0.0) step.x_m = c.step_length_m;
  return {step, c.steps * footfall_s, 0.0};
}

std::optional<Failure> CheckExtent(const WalkCommand& c) {
  if (c.extent == Extent::kDistance && c.distance_m < 0.0)
    return BadCommand(fmt::format("the distance is {} m; it must not be negative", c.distance_m));
  if (c.extent == Extent::kDuration && c.duration_s <= 0.0)
    return BadCommand(fmt::format("the duration is {} s; it must be more than 0", c.duration_s));
  if (c.extent == Extent::kSteps && c.steps < 1)
    return BadCommand(fmt::format("the number of steps is {}; it must be 1 or more", c.steps));
  if (c.extent == Extent::kSteps && c.speed_m_s != 0.0 && c.step_length_m != 0.0) {
    return BadCommand(
        fmt::format("counted steps have a length of {} m and a forward speed of {} m/s; give only one of them",
                    c.step_length_m, c.speed_m_s));
  }
  constexpr double kHalfTurn = 3.15;  // [rad] half a turn, rounded up
  if (std::abs(c.goal_yaw_rad) > kHalfTurn)
    return BadCommand(fmt::format("the goal's yaw is {} rad; it must lie between -pi and pi", c.goal_yaw_rad));
  return std::nullopt;
}

}  // namespace

std::optional<Failure> CheckCommand(const WalkCommand& c) {
  constexpr double kMost = 1e6;  // of any number, in its unit
  for (const double value : {c.speed_m_s, c.lateral_speed_m_s, c.yaw_rate_rad_s, c.distance_m, c.duration_s, c.goal_x_m,
                             c.goal_y_m, c.goal_yaw_rad, c.step_length_m}) {
    if (!std::isfinite(value))
      return BadCommand(fmt::format("the command contains {}; all numbers must be finite", value));
    if (std::abs(value) > kMost)
      return BadCommand(fmt::format("the command contains {}; at most +-{} is accepted", value, kMost));
  }
  if (c.extent == Extent::kGoal && c.speed_m_s < 0.0)
    return BadCommand(fmt::format(
        "the speed is {} m/s; toward a goal it must not be negative: the goal gives the direction", c.speed_m_s));
  return CheckExtent(c);
}

double CommandedSpeed(const RobotModel& model, const WalkCommand& command) {
  return command.speed_m_s != 0.0 ? std::abs(command.speed_m_s) : model.nominal_speed_m_s;
}

double SpeedOfSteps(const RobotModel& model, const WalkCommand& command) {
  const double lateral = command.extent == Extent::kGoal ? 0.0 : std::abs(command.lateral_speed_m_s);
  return std::max(CommandedSpeed(model, command), model.legs.size() == 2 ? 2.0 * lateral : lateral);
}

PlanarTwist FittingSpeeds(const RobotModel& model, const Gait& gait, const WalkCommand& c) {
  const double speed = CommandedSpeed(model, c);
  return {speed, c.lateral_speed_m_s != 0.0 ? std::abs(c.lateral_speed_m_s) : 0.35 * speed,
          c.yaw_rate_rad_s != 0.0 ? std::abs(c.yaw_rate_rad_s) : OwnTurnRate(model, gait, speed)};
}

PlanarTwist CommandedVelocity(const RobotModel& model, const WalkCommand& c) {
  PlanarTwist velocity{c.speed_m_s, c.lateral_speed_m_s, c.yaw_rate_rad_s};
  if (c.extent == Extent::kSteps || c.speed_m_s != 0.0 || c.lateral_speed_m_s != 0.0) return velocity;
  const bool on_the_spot = c.yaw_rate_rad_s != 0.0 && (c.extent == Extent::kDuration || c.distance_m == 0.0);
  if (!on_the_spot) velocity.x_m = model.nominal_speed_m_s;
  return velocity;
}

bool IsCounted(const WalkCommand& command) {
  return command.extent == Extent::kSteps || (command.extent == Extent::kGoal && command.steps > 0);
}

Result<Course> MakeCourse(const RobotModel& model, const Gait& gait, const WalkCommand& command,
                          const SpeedRamp& ramp) {
  constexpr double kLongest = 600.0;  // [s]
  Course course;
  switch (command.extent) {
    case Extent::kGoal:
      course = IsCounted(command) ? OfSteps(model, gait, command) : ToGoal(model, gait, command);
      break;
    case Extent::kDistance:
      course = AlongDistance(model, command);
      break;
    case Extent::kDuration:
      course = ForDuration(model, gait, command, ramp);
      break;
    case Extent::kSteps:
      course = OfSteps(model, gait, command);
      break;
  }
  if (!(course.duration_s > 0.0)) return BadCommand("the command has no effect: it ends where it starts");
  if (course.duration_s > kLongest) {
    return BadCommand(
        fmt::format("the walk would take {:.6g} s; a plan lasts at most {} s; reduce the distance or raise the speed",
                    course.duration_s, kLongest));
  }
  if (!IsCounted(command) && command.extent != Extent::kDuration) {
    course.ramp_s = std::min(RampTime(model, gait, command, ramp), course.duration_s);
    course.duration_s += course.ramp_s;
  }
  return course;
}

}  // namespace gaitwright
