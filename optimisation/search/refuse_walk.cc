// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/search/refuse_walk.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <set>

#include "planning/footsteps/course.h"

namespace gaitwright {
namespace {

using Extent = WalkCommand::Extent;

/// Rounded towards zero to some significant digits.
double Digits(double value, int digits) {
  if (value == 0.0) return 0.0;
  const double unit = std::pow(10.0, std::floor(std::log10(std::abs(value)) + 1e-12) - digits + 1);
  const double rounded = std::trunc(value / unit + std::copysign(1e-6, value));
  return std::stod(fmt::format("{:.{}g}", rounded * unit, digits));
}

bool IsLimit(const Violation& v) {
  static const std::set<Law> kLimits = {Law::kJointPosition,    Law::kJointVelocity, Law::kJointAcceleration,
                                        Law::kJointJerk,        Law::kJointTorque,   Law::kTorqueSpeed,
                                        Law::kContinuousTorque, Law::kReach,         Law::kSelfCollision};
  return kLimits.contains(v.law);
}

double Passed(const Violation& v) { return std::abs(v.value - v.limit) / std::max(std::abs(v.limit), 1e-9); }

/// A pace beyond that of any leg: that of a pendulum of the leg's length, three times.
double Beyond(const RobotModel& model, Pace pace) {
  const double leg = model.leg_length_m(), speed = 3.0 * std::sqrt(kGravity * leg);
  return pace == Pace::kStepLength ? 2.0 * leg : pace == Pace::kYawRate ? speed / leg : speed;
}

/// The numbers of two digits between two others, both left out.
std::vector<double> TwoDigitsBetween(double low, double high) {
  std::vector<double> values;
  const double decade = std::floor(std::log10(low) + 1e-12);
  for (double power : {std::pow(10.0, decade), std::pow(10.0, decade + 1.0)}) {
    for (int tenth = 10; tenth < 100; ++tenth) {
      const double value = Digits(0.1 * tenth * power, 2);
      if (value > low * (1.0 + 1e-9) && value < high * (1.0 - 1e-9)) values.push_back(value);
    }
  }
  return values;
}

/// Largest of the numbers of two digits between `known` and `high` that is possible, else `known`, by bisection.
double LargestBetween(double known, double high, const std::function<bool(double)>& possible) {
  const std::vector<double> between = TwoDigitsBetween(known, high);
  const auto first_impossible =
      std::partition_point(between.begin(), between.end(), [&](double value) { return possible(value); });
  return first_impossible == between.begin() ? known : *(first_impossible - 1);
}

}  // namespace

bool IsTooMuch(const Failure& failure) {
  static const std::set<FailureCode> kWhateverThePace = {
      FailureCode::kGait,        FailureCode::kPassiveJoint, FailureCode::kFreedoms,     FailureCode::kHeight,
      FailureCode::kNoSupport,   FailureCode::kNoFootholds,  FailureCode::kSearchBudget, FailureCode::kStartBlocked,
      FailureCode::kGoalBlocked, FailureCode::kWayBlocked,   FailureCode::kWayNotFound};
  return failure.kind == FailureKind::kInfeasible && !kWhateverThePace.contains(failure.code);
}

std::vector<Violation> BrokenLimits(const AuditReport& audit) {
  std::vector<Violation> broken;
  std::copy_if(audit.violations.begin(), audit.violations.end(), std::back_inserter(broken), IsLimit);
  std::stable_sort(broken.begin(), broken.end(),
                   [](const Violation& a, const Violation& b) { return Passed(a) > Passed(b); });
  const auto too_fast = [&](const std::string& where) {
    return std::any_of(broken.begin(), broken.end(),
                       [&](const Violation& v) { return v.law == Law::kJointVelocity && v.where == where; });
  };
  std::vector<Violation> causes,
      followers;  // a motor past its no-load speed has no torque left, however little it needs
  for (const Violation& v : broken) (v.law == Law::kTorqueSpeed && too_fast(v.where) ? followers : causes).push_back(v);
  causes.insert(causes.end(), followers.begin(), followers.end());
  return causes;
}

std::vector<Violation> Forbidding(const AuditReport& audit) {
  std::vector<Violation> forbidding = BrokenLimits(audit);
  std::copy_if(audit.violations.begin(), audit.violations.end(), std::back_inserter(forbidding),
               [](const Violation& v) { return !IsLimit(v); });
  return forbidding;
}

bool IsSound(const Result<PlannedWalk>& planned) {
  return planned && planned->motion.limit_excess < kSlightExcess && Forbidding(planned->audit).empty();
}

Failure WhyForbidden(const PlannedWalk& planned) {
  const std::vector<Violation> forbidding = Forbidding(planned.audit);
  if (forbidding.empty()) {  // limits that are passed between the audit's samples
    std::string text;
    for (const std::string& warning : planned.motion.plan.warnings) text += (text.empty() ? "" : "; ") + warning;
    return {FailureKind::kInfeasible, FailureCode::kLimits, "PlanWalk", text, {AllowLimits()}};
  }
  const std::size_t limits = BrokenLimits(planned.audit).size();
  return {
      FailureKind::kInfeasible,
      limits > 0 ? FailureCode::kLimits : FailureCodeOf(forbidding.front().law),
      "PlanWalk",
      LimitText(forbidding.front()) + (limits > 1 ? fmt::format(" (worst of {} limits that are broken)", limits) : ""),
      {AllowLimits()},
      forbidding.front()};
}

FailureCode ReasonRefused(const Result<PlannedWalk>& planned) {
  return planned ? WhyForbidden(*planned).code : planned.failure().code;
}

std::string LimitText(const Violation& v) {
  if (v.law == Law::kSelfCollision) return fmt::format("{} collide at {:.2f} s", v.where, v.at_s);
  if (v.law == Law::kDynamics && v.where.starts_with("base")) {
    return fmt::format(
        "at {:.2f} s the feet on the ground cannot push as the motion needs: {:.3g} {} are lacking, "
        "where {:.2g} may be; there is too little friction, or too little ground to balance on",
        v.at_s, v.value, v.unit, v.limit);
  }
  if (v.law == Law::kZmpSupport) {
    return fmt::format("the {} is {:.1f} mm outside the feet on the ground at {:.2f} s, where {:.2g} mm may be",
                       v.where, 1e3 * v.value, v.at_s, 1e3 * v.limit);
  }
  if (v.law == Law::kBodyClearance)
    return fmt::format("'{}' is {:.1f} mm in the ground or an obstacle at {:.2f} s", v.where, -1e3 * v.value, v.at_s);
  if (!IsLimit(v)) {
    return fmt::format("the plan breaks the law '{}': {}, {:.4g} {} at {:.2f} s (limit {:.4g})", LawName(v.law),
                       v.where, v.value, v.unit, v.at_s, v.limit);
  }
  const char* what = v.law == Law::kJointTorque         ? "needs"
                     : v.law == Law::kTorqueSpeed       ? "needs, at the speed that it has,"
                     : v.law == Law::kContinuousTorque  ? "needs, as a mean over time,"
                     : v.law == Law::kJointVelocity     ? "moves at"
                     : v.law == Law::kJointAcceleration ? "accelerates at"
                     : v.law == Law::kJointJerk         ? "changes its acceleration by"
                     : v.law == Law::kJointPosition     ? "is at"
                                                        : "reaches for";
  return fmt::format("'{}' {} {:.4g} {} at {:.2f} s, {:.3g} {} past its limit of {:.4g}", v.where, what, v.value,
                     v.unit, v.at_s, std::abs(v.value - v.limit), v.unit, v.limit);
}

Pace PaceOf(const WalkCommand& c) {
  if (c.extent == Extent::kSteps && c.speed_m_s == 0.0 && c.step_length_m != 0.0) return Pace::kStepLength;
  if (c.speed_m_s > 0.0) return Pace::kSpeed;
  const bool aside = c.extent != Extent::kGoal || c.goal_x_m == 0.0;
  if (c.lateral_speed_m_s != 0.0 && aside) return Pace::kLateralSpeed;
  const bool on_the_spot =
      c.extent == Extent::kGoal ? aside && c.goal_y_m == 0.0 : c.extent != Extent::kDistance || c.distance_m == 0.0;
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
  c.speed_m_s = pace == Pace::kSpeed ? value : Digits(factor * command.speed_m_s, 4);
  c.lateral_speed_m_s = Digits(factor * command.lateral_speed_m_s, 4);
  c.yaw_rate_rad_s = Digits(factor * command.yaw_rate_rad_s, 4);
  c.step_length_m = Digits(factor * command.step_length_m, 4);
  return c;
}

WalkCommand Shortened(const RobotModel& model, const WalkCommand& command, const Gait& gait) {
  constexpr double kCycles = 4.0;
  const double cycle_s = gait.cycle_s;
  WalkCommand c = command;
  const PlanarTwist velocity = CommandedVelocity(model, command);
  const double speed = std::hypot(velocity.x_m, velocity.y_m);
  if (speed > 0.0) c.distance_m = std::min(c.distance_m, kCycles * cycle_s * speed);
  c.duration_s = std::min(c.duration_s, kCycles * cycle_s);
  const bool turns = c.extent == Extent::kDistance && speed == 0.0;
  if (turns && 0.5 * std::numbers::pi > kCycles * cycle_s * std::abs(velocity.yaw_rad)) {
    c.extent = Extent::kDuration;
    c.duration_s = kCycles * cycle_s;
  }
  c.steps = std::min(c.steps, static_cast<int>(kCycles * static_cast<double>(model.feet.size())));
  if (c.extent != Extent::kGoal) return c;
  const Result<Course> course = MakeCourse(model, gait, command, {});
  if (course && course->duration_s > kCycles * cycle_s) {
    const PlanarPose near = PoseAlong(course->twist, kCycles * cycle_s / course->duration_s);
    c.goal_x_m = near.x_m;
    c.goal_y_m = near.y_m;
    c.goal_yaw_rad = near.yaw_rad;
  }
  return c;
}

double LargestPace(const RobotModel& model, const WalkCommand& command, const CanWalk& can_walk) {
  // A goal is not walked to ever slower, since one plan does not last so long.
  const int most_halvings = command.extent == Extent::kGoal ? 5 : 9;
  const auto possible = [&](double value) { return can_walk(AtPace(model, command, value)); };
  double high = PaceValue(model, command);
  const double beyond = Beyond(model, PaceOf(command));
  double low = Digits(std::min(0.5 * high, beyond), 2);
  if (!possible(Digits(std::ldexp(low, -most_halvings), 2))) return 0.0;
  int halvings = 0;
  while (halvings < most_halvings && !possible(low)) {
    high = low;
    low = Digits(0.5 * low, 2);
    ++halvings;
  }
  if (halvings == most_halvings) return 0.0;
  return LargestBetween(low, high, possible);
}

double LargestPaceAbove(const RobotModel& model, const WalkCommand& command, double known, int grain,
                        const CanWalk& can_walk) {
  const auto possible = [&](double value) { return can_walk(AtPace(model, command, value)); };
  const std::vector<double> between = TwoDigitsBetween(known, PaceValue(model, command));
  const auto least = static_cast<std::size_t>(grain);
  std::size_t below = 0, end = between.size(), stride = 1;  // possible before `below`, impossible from `end` on
  while (end - below >= (below == 0 ? 1 : least)) {
    const std::size_t next = std::min(below + stride - 1, (below + end) / 2);
    const bool is_possible = possible(between[next]);
    stride = is_possible ? 2 * stride : between.size();
    (is_possible ? below : end) = is_possible ? next + 1 : next;
  }
  return below == 0 ? known : between[below - 1];
}

double NextLower(double value) { return TwoDigitsBetween(0.5 * value, value).back(); }

Suggestion AllowLimits() {
  return {"pipeline.allow_limits", "true", Certainty::kPlanned,
          "--set pipeline.allow_limits=true gives the plan all the same"};
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

}  // namespace gaitwright
