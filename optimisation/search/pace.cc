// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/search/pace.h"

#include <fmt/format.h>

#include <cmath>

#include "optimisation/search/pace_search.h"
#include "planning/footsteps/course.h"

namespace gaitwright {
namespace {

using Extent = WalkCommand::Extent;

}  // namespace

std::string PaceName(Pace pace) {
  switch (pace) {
    case Pace::kSpeed:
      return "speed";
    case Pace::kLateralSpeed:
      return "lateral speed";
    case Pace::kYawRate:
      return "turning rate";
    case Pace::kStepLength:
      return "step length";
  }
  return "";
}

std::string PaceFlag(Pace pace) {
  switch (pace) {
    case Pace::kSpeed:
      return "speed";
    case Pace::kLateralSpeed:
      return "lateral-speed";
    case Pace::kYawRate:
      return "yaw-rate";
    case Pace::kStepLength:
      return "step-length";
  }
  return "";
}

std::string PaceUnit(Pace pace) { return pace == Pace::kYawRate ? "rad/s" : pace == Pace::kStepLength ? "m" : "m/s"; }

std::string PaceText(const WalkCommand& command) {
  switch (PaceOf(command)) {
    case Pace::kSpeed:
      return fmt::format("{:.2g} m/s", std::abs(command.speed_m_s));
    case Pace::kLateralSpeed:
      return fmt::format("{:.2g} m/s", std::abs(command.lateral_speed_m_s));
    case Pace::kYawRate:
      return fmt::format("{:.2g} rad/s", std::abs(command.yaw_rate_rad_s));
    case Pace::kStepLength:
      return fmt::format("{:.2g} m", std::abs(command.step_length_m));
  }
  return "";
}

std::string PaceFlags(const WalkCommand& c) {
  std::string flags;
  const auto add = [&](const char* flag, double value) {
    if (value != 0.0) flags += fmt::format("{}{} {:.4g}", flags.empty() ? "" : " ", flag, value);
  };
  add("--speed", c.speed_m_s);
  add("--lateral-speed", c.lateral_speed_m_s);
  add("--yaw-rate", c.yaw_rate_rad_s);
  if (c.extent == Extent::kSteps) add("--step-length", c.step_length_m);
  return flags;
}

Pace PaceOf(const WalkCommand& c) {
  if (c.extent == Extent::kSteps && c.speed_m_s == 0.0 && c.step_length_m != 0.0) return Pace::kStepLength;
  if (c.speed_m_s != 0.0) return Pace::kSpeed;
  const bool no_forward_goal = c.extent != Extent::kGoal || c.goal_x_m == 0.0;
  if (c.lateral_speed_m_s != 0.0 && no_forward_goal) return Pace::kLateralSpeed;
  const bool on_the_spot = c.extent == Extent::kGoal ? no_forward_goal && c.goal_y_m == 0.0
                                                     : c.extent != Extent::kDistance || c.distance_m == 0.0;
  return c.yaw_rate_rad_s != 0.0 && on_the_spot ? Pace::kYawRate : Pace::kSpeed;
}

double PaceValue(const RobotModel& model, const WalkCommand& c) {
  switch (PaceOf(c)) {
    case Pace::kSpeed:
      return CommandedSpeed(model, c);
    case Pace::kLateralSpeed:
      return std::abs(c.lateral_speed_m_s);
    case Pace::kYawRate:
      return std::abs(c.yaw_rate_rad_s);
    case Pace::kStepLength:
      return std::abs(c.step_length_m);
  }
  return 0.0;
}

WalkCommand AtPace(const RobotModel& model, const WalkCommand& command, double value) {
  const Pace pace = PaceOf(command);
  const double factor = value / PaceValue(model, command);
  WalkCommand c = command;
  c.speed_m_s =
      pace == Pace::kSpeed ? std::copysign(value, command.speed_m_s) : TowardsZero(factor * command.speed_m_s, 4);
  c.lateral_speed_m_s = TowardsZero(factor * command.lateral_speed_m_s, 4);
  c.yaw_rate_rad_s = TowardsZero(factor * command.yaw_rate_rad_s, 4);
  c.step_length_m = TowardsZero(factor * command.step_length_m, 4);
  return c;
}

double UnreachablePace(const RobotModel& model, Pace pace) {
  const double leg = model.leg_length_m(), speed = 3.0 * std::sqrt(kGravity * leg);
  return pace == Pace::kStepLength ? 2.0 * leg : pace == Pace::kYawRate ? speed / leg : speed;
}

}  // namespace gaitwright
