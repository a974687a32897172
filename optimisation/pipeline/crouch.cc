// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/pipeline/crouch.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <vector>

#include "kinematics/model/actuator.h"
#include "optimisation/pipeline/leg_motors.h"
#include "optimisation/pipeline/robot_body.h"

namespace gaitwright {
namespace {

constexpr double kUse = 0.95;          // share of the motors' effort limits
constexpr double kJointMargin = 0.03;  // share of the joints' ranges
constexpr double kSpeedMargin = 1.3;   // times the lift-off speed; the margin is for rotation and forward motion
constexpr double kLeastSpeed = 1.15;   // smallest accepted factor; a push ends gradually

/// The longest flight of a schedule, and the largest number of feet that push at once since the flight before.
struct PushedFlight {
  double start_s = 0.0, duration_s = 0.0;
  int pushing = 0;
};

PushedFlight LongestPushedFlight(const ContactSchedule& schedule) {
  PushedFlight longest;
  int pushing = 0;
  for (const ContactPhase& phase : schedule.phases) {
    const double duration_s = phase.end_s - phase.start_s;
    if (phase.stance == 0 && duration_s > longest.duration_s) longest = {phase.start_s, duration_s, pushing};
    pushing = phase.stance == 0 ? 0 : std::max(pushing, std::popcount(phase.stance));
  }
  return longest;
}

/// Upward speed at each height that the torques give from rest at the lowest height at which they hold the body, with
/// torque-speed curves and without speed limits [m/s]: v dv = a(z, v) dz.
std::vector<double> SpeedByTorque(const RobotModel& model, const std::vector<PushOff>& at) {
  std::vector<double> speed(at.size(), 0.0);
  double squared = 0.0;
  for (std::size_t i = at.size() - 1; i-- > 0;) {
    const double before = std::sqrt(squared);
    squared += (GainAtSpeed(model, at[i], before, kUse) + GainAtSpeed(model, at[i + 1], before, kUse)) *
               (at[i].com_m - at[i + 1].com_m);
    squared = std::max(0.0, squared);
    speed[i] = std::sqrt(squared);
  }
  return speed;
}

std::string MotorText(const RobotModel& model, int index, bool speed) {
  if (index < 0) return "no motor is at its limit";
  const Actuator motor = ActuatorOf(model, index);
  return speed ? fmt::format("'{}' is limited to {:.3g} rad/s", motor.name, motor.velocity_limit)
               : fmt::format("'{}' is limited to {:.3g} N m", motor.name, motor.effort_limit);
}

Failure CannotFly(const RobotModel& model, const PushedFlight& flight, const PushOff& best, double gives,
                  bool by_speed) {
  const double takes = 0.5 * kGravity * flight.duration_s, longest_s = 2.0 * gives / (kLeastSpeed * kGravity);
  std::vector<Suggestion> suggestions = {
      {"gait.cycle_s", {}, Certainty::kUntried, "a shorter cycle (--set gait.cycle_s)"},
      {"gait.duty_factor", {}, Certainty::kUntried, "a larger duty factor (--set gait.duty_factor)"}};
  if (longest_s > 0.005) suggestions.insert(suggestions.begin(), fmt::format("flights of {:.3f} s at most", longest_s));
  return {FailureKind::kInfeasible, by_speed ? FailureCode::kLegsTooSlow : FailureCode::kLegsTooWeak, "CrouchFor",
          fmt::format(
              "a flight of {:.3f} s at {:.2f} s, in which the centre of mass rises by {:.3f} m, needs a "
              "lift-off speed of {:.2f} m/s; because a push ends gradually, the legs must reach {:.2f} m/s. With flat "
              "soles and a level body, the legs of '{}' reach at most {:.2f} m/s, with the centre of mass at {:.3f} m, "
              "where {}",
              flight.duration_s, flight.start_s, 0.5 * takes * takes / kGravity, takes, kLeastSpeed * takes, model.name,
              gives, best.com_m, MotorText(model, by_speed ? best.fastest : best.strongest, by_speed)),
          suggestions};
}

/// The robot with that posture as its standing posture.
Crouch At(const RobotModel& model, const VectorX& carried) {
  Crouch crouch;
  crouch.model = model;
  crouch.model.standing_joints = carried.tail(model.num_dofs());
  crouch.model.standing_base_height_m = carried[2];
  crouch.p_SB = Vector3(carried[0], carried[1], 0.0);
  return crouch;
}

/// The crouch for the flights; nothing if the standing posture is sufficient.
Result<std::optional<Crouch>> ForFlights(const RobotModel& model, const ContactSchedule& schedule) {
  constexpr double kLeastStroke = 0.02;  // share of the leg length
  const PushedFlight flight = LongestPushedFlight(schedule);
  if (flight.duration_s == 0.0 || flight.pushing == 0) return std::optional<Crouch>();
  const std::vector<PushOff> at = PushOffs(model, flight.pushing, kJointMargin, kUse);
  if (at.empty()) return std::optional<Crouch>();
  const double takes = 0.5 * kGravity * flight.duration_s, standing_m = StandingCentreOfMass(model).z();
  const std::vector<double> by_torque = SpeedByTorque(model, at);
  const auto gives = [&](std::size_t i) { return std::min(kUse * at[i].speed_m_s, by_torque[i]); };
  std::size_t best = 0;
  for (std::size_t i = 1; i < at.size(); ++i) {
    if (gives(i) > gives(best)) best = i;
  }
  if (gives(best) < kLeastSpeed * takes) {
    const bool by_speed = kUse * at[best].speed_m_s <= by_torque[best];
    return CannotFly(model, flight, at[best], gives(best), by_speed);
  }
  const auto fast_enough = [&](const PushOff& p) { return kUse * p.speed_m_s >= kSpeedMargin * takes; };
  const auto stands = std::find_if(at.begin(), at.end(), [&](const PushOff& p) { return p.com_m < standing_m + 1e-9; });
  if (stands != at.end() && fast_enough(*stands)) return std::optional<Crouch>();
  // The highest posture with a margin, or the one with the largest margin.
  const auto first = std::find_if(stands, at.end(), fast_enough);
  const std::size_t highest = first == at.end() ? best : std::min(best, static_cast<std::size_t>(first - at.begin()));
  const double stroke_m =
      std::max(kLeastStroke * model.leg_length_m(), takes * takes / std::max(at[highest].gain_m_s2, 1e-3));
  std::size_t carried = highest;
  while (carried + 1 < at.size() && at[carried].com_m > at[highest].com_m - stroke_m) ++carried;
  Crouch crouch = At(model, at[carried].q);
  crouch.flight_s = flight.duration_s;
  crouch.highest_m = at[highest].com_m;
  crouch.fastest_m_s = kUse * at[highest].speed_m_s;
  return std::optional<Crouch>(crouch);
}

/// The crouch for a height of the centre of mass, within the requirements of the flights.
Result<std::optional<Crouch>> AtHeight(const RobotModel& model, double com_height_m,
                                       const std::optional<Crouch>& needed) {
  const std::vector<PushOff> at = PushOffs(model, static_cast<int>(model.feet.size()), 0.0, 1.0);
  const double highest_m = needed ? needed->highest_m : at.front().com_m, lowest_m = at.back().com_m;
  const auto below = std::find_if(at.begin(), at.end(), [&](const PushOff& p) { return p.com_m <= com_height_m; });
  if (com_height_m > highest_m || below == at.end()) {
    return Failure{FailureKind::kInfeasible,
                   FailureCode::kHeight,
                   "CrouchFor",
                   fmt::format("the centre of mass of '{}' cannot be at a height of {:.3f} m: {}, with a level body on "
                               "flat feet, {:.3f} to {:.3f} m are possible",
                               model.name, com_height_m, needed ? "with legs fast enough for the flights" : "with legs",
                               lowest_m, highest_m),
                   {"set another pipeline.com_height_m; 0 uses the robot's default"}};
  }
  // Between two neighbouring postures (1 % of the leg length apart), joints are nearly linear in height.
  const auto above = below == at.begin() ? below : below - 1;
  const double rise_m = above->com_m - below->com_m;
  const double share = rise_m > 0.0 ? (com_height_m - below->com_m) / rise_m : 0.0;
  Crouch crouch = At(model, below->q + share * (above->q - below->q));
  if (needed) {
    crouch.flight_s = needed->flight_s;
    crouch.highest_m = needed->highest_m;
    crouch.fastest_m_s = needed->fastest_m_s;
  }
  return std::optional<Crouch>(crouch);
}

}  // namespace

Result<std::optional<Crouch>> CrouchFor(const RobotModel& model, const ContactSchedule& schedule, double com_height_m) {
  Result<std::optional<Crouch>> needed = ForFlights(model, schedule);
  return needed && com_height_m > 0.0 ? AtHeight(model, com_height_m, *needed) : needed;
}

}  // namespace gaitwright
