// SPDX-License-Identifier: BSD-3-Clause
#include "playback/score/reason_of_fall.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "kinematics/model/dof_units.h"
#include "planning/plan/plans_contacts_internal.h"
#include "playback/score/capture.h"
#include "playback/score/contact_timing.h"
#include "playback/score/failure_events_internal.h"
#include "playback/score/gates.h"
#include "playback/score/log_options_internal.h"

namespace gaitwright {
namespace {

using Kind = FailureEvent::Kind;

constexpr double kFarOff = 0.03;  // from the plan or the foothold, for the reference leg [m]

double Scaled(const ScoreInputs& in, double length_m) { return length_m * in.leg_length_m / kReferenceLegLength; }

/// "to the left": the main direction of a vector, seen from the base.
std::string DirectionOf(const Vector2& d_W, double base_yaw_rad) {
  const Vector2 d = Eigen::Rotation2Dd(-base_yaw_rad) * d_W;
  if (std::abs(d.x()) > std::abs(d.y())) return d.x() > 0.0 ? "forward" : "backward";
  return d.y() > 0.0 ? "to the left" : "to the right";
}

Event ContactLost(const ScoreInputs& in) {
  Event first;
  for (int foot = 0; foot < static_cast<int>(in.model.feet.size()); ++foot) {
    double off_since = -1.0;
    for (std::size_t k = 0; k < in.series.measured.size(); ++k) {
      const LogSample& sample = in.log.samples[k];
      const bool off = Contains(in.series.measured[k].stance, foot) && !Contains(sample.contact, foot);
      if (!off) off_since = -1.0;
      if (off && off_since < 0.0) off_since = sample.time_s;
      if (!off || sample.time_s - off_since < TimingGate()) continue;
      if (!first || off_since < first->time_s) {
        first = FailureEvent{Kind::kContactLost, off_since,
                             fmt::format("at {:.2f} s '{}' was off the ground, although the schedule has it in stance",
                                         off_since, FootName(in, foot))};
      }
      break;
    }
  }
  return first;
}

Event EarlyContact(const ScoreInputs& in) {
  Event first;
  const int feet = static_cast<int>(in.model.feet.size());
  for (const auto& swing : ScuffedSwings(in.plan.schedule, in.log, feet, TimingGate(), in.fall.time_s)) {
    for (const StanceRecord& stance : in.log.stances) {
      const bool inside = stance.foot == swing.foot && stance.liftoff_s > swing.liftoff_s + TimingGate() &&
                          stance.touchdown_s < swing.touchdown_s - TimingGate();
      const double at = std::max(stance.touchdown_s, swing.liftoff_s);
      if (!inside || (first && first->time_s <= at)) continue;
      const char* how = stance.touchdown_s <= swing.liftoff_s ? "stayed on the ground after its swing began"
                                                              : "touched the ground in mid swing";
      first =
          FailureEvent{Kind::kEarlyContact, at, fmt::format("at {:.2f} s '{}' {}", at, FootName(in, swing.foot), how)};
    }
  }
  return first;
}

/// Error of a foot's place at touch-down relative to its foothold, minus the drift of the base if that explains it.
Vector2 FootholdError(const ScoreInputs& in, const StanceRecord& stance, const Foothold& foothold, std::size_t k) {
  const MotionSample &actual = in.series.measured[k], &wanted = in.series.planned[k];
  const Vector2 there = stance.p_touchdown_W.head<2>(), here = foothold.X_WF.translation().head<2>();
  const SupportMotion drift{wanted.X_WB.translation().head<2>(), actual.X_WB.translation().head<2>(),
                            WrapAngle(YawOf(actual.X_WB.linear()) - YawOf(wanted.X_WB.linear()))};
  const Vector2 in_world = there - here, beside_base = drift.Back(there) - here;
  return in_world.norm() < beside_base.norm() ? in_world : beside_base;
}

Event MissedFoothold(const ScoreInputs& in) {
  for (const StanceRecord& stance : in.log.stances) {
    if (stance.touchdown_s > in.fall.time_s || stance.touchdown_s <= in.log.start_s + TimingGate()) continue;
    const auto foothold =
        std::find_if(in.plan.footsteps.footholds.begin(), in.plan.footsteps.footholds.end(), [&](const Foothold& f) {
          return f.foot == stance.foot && std::abs(f.touchdown_s - stance.touchdown_s) < 2.5 * TimingGate();
        });
    const auto k = std::find_if(in.series.measured.begin(), in.series.measured.end(),
                                [&](const MotionSample& s) { return s.time_s >= stance.touchdown_s; });
    if (foothold == in.plan.footsteps.footholds.end() || k == in.series.measured.end()) continue;
    const Vector2 error =
        FootholdError(in, stance, *foothold, static_cast<std::size_t>(k - in.series.measured.begin()));
    if (error.norm() <= Scaled(in, kFarOff)) continue;
    return FailureEvent{
        Kind::kMissedFoothold, stance.touchdown_s,
        fmt::format("at {:.2f} s '{}' came down {:.0f} mm off its foothold, {}", stance.touchdown_s,
                    FootName(in, stance.foot), 1e3 * error.norm(), DirectionOf(error, YawOf(k->X_WB.linear())))};
  }
  return {};
}

Event Slip(const ScoreInputs& in) {
  const double gate = LimitOf(RuleOf("slip_max_step_m"), ScaleOf(in.model, in.plan)).value_or(0.0);
  Event first;
  for (const StanceRecord& stance : in.log.stances) {
    if (stance.slip_m <= gate || stance.touchdown_s > in.fall.time_s) continue;
    double slid = 0.0, at = std::min(stance.liftoff_s, in.fall.time_s);
    for (const MotionSample& sample : in.series.measured) {
      if (sample.time_s < stance.touchdown_s || sample.time_s > stance.liftoff_s) continue;
      slid += sample.feet[static_cast<std::size_t>(stance.foot)].slide_m_s / in.log.log_rate_hz;
      if (slid > gate) at = std::min(at, sample.time_s);
    }
    if (first && first->time_s <= at) continue;
    first = FailureEvent{Kind::kSlip, at,
                         fmt::format("by {:.2f} s '{}' had slid more than {:.1f} mm (in all {:.1f} mm in that stance)",
                                     at, FootName(in, stance.foot), 1e3 * gate, 1e3 * stance.slip_m)};
  }
  return first;
}

/// " of 33.50 N m (reduced by the motor's warmth)", if a motor's current limit is below the robot's limit.
std::string WhatIsLeft(const ScoreInputs& in, int index, const LogSample& sample) {
  constexpr double kNear = 0.98;  // of a limit, because speeds are those at the end of a sample
  const Actuator& actuator = in.motors[static_cast<std::size_t>(index)];
  const double whole = actuator.effort_limit, limit = sample.tau_peak[index];
  if (limit > kNear * whole || !HasTorqueLimit(actuator)) return "";
  const LogOptions options(in.log);
  const Motor& motor = actuator.motor;
  std::vector<std::string> takers;
  const double strong = options.At("play.motor_strength", 1.0) * whole;
  if (strong < kNear * whole) takers.emplace_back("strength");
  const double speed =
      std::copysign(1.0, actuator.Effort(sample.tau)) * actuator.Speed(sample.v.tail(in.model.num_dofs()));
  const double fast = options.Text("play.motor_curve") == "false" ? strong : motor.EffortAt(speed, strong);
  if (fast < kNear * strong) takers.emplace_back("speed");
  const bool warms = motor.continuous_effort < strong && options.Text("play.thermal_limit") != "false";
  if (warms && limit < kNear * fast) takers.emplace_back("warmth");
  const std::string whole_limit = fmt::format(" of {:.2f} {}", whole, actuator.effort_unit());
  return takers.empty() ? whole_limit
                        : fmt::format("{} (reduced by the motor's {})", whole_limit, fmt::join(takers, " and "));
}

Event TorqueLimit(const ScoreInputs& in) {
  Event first;
  for (int i = 0; i < in.model.num_dofs(); ++i) {
    const Actuator& motor = in.motors[static_cast<std::size_t>(i)];
    if (!MayBeAtALimit(motor)) continue;
    const auto at =
        FirstPersistent(in.series.measured, [&](std::size_t k) { return in.log.samples[k].effort_use[i] >= 1.0; });
    if (!at || (first && first->time_s <= in.series.measured[*at].time_s)) continue;
    const double time = in.series.measured[*at].time_s;
    first = FailureEvent{Kind::kTorqueLimit, time,
                         fmt::format("the torque of '{}' was at its limit {:.2f} {}{} from {:.2f} s", motor.name,
                                     in.log.samples[*at].tau_peak[i], motor.effort_unit(),
                                     WhatIsLeft(in, i, in.log.samples[*at]), time)};
  }
  return first;
}

/// Distance of the DCM to the region from which the remaining steps, the last at `last_step_s`, can catch it; to the
/// support if no step remains.
double Catchable(const ScoreInputs& in, std::size_t k, double last_step_s, double reach_m, DynamicsScratch& scratch) {
  const MotionSample& sample = in.series.measured[k];
  const double now = SignedDistance(sample.support.polygon, sample.dcm_W);
  if (now >= 0.0 || last_step_s <= sample.time_s) return now;
  ForwardKinematics(in.model, in.log.samples[k].q, scratch);
  const auto stages = StagesToNextTouchdown(in.plan, sample.time_s);
  return CaptureMargin(in.model, scratch, in.plan.terrain, stages, sample, reach_m).value_or(now);
}

Event DcmOut(const ScoreInputs& in) {
  const double reach = StepReach(in.model, in.options.stretch);
  const std::vector<double> touchdowns = TouchdownTimes(in.plan.schedule);
  const double last_step = touchdowns.empty() ? in.log.start_s : touchdowns.back();
  DynamicsScratch scratch(in.model);
  const auto& measured = in.series.measured;
  const auto out = [&](std::size_t k) {
    const MotionSample &actual = measured[k], &wanted = in.series.planned[k];
    if (actual.support.empty() || Catchable(in, k, last_step, reach, scratch) >= 0.0) return false;
    const SupportMotion motion = MotionBetween(wanted.support, actual.support);
    return (motion.Back(actual.dcm_W) - wanted.dcm_W).norm() > Scaled(in, kFarOff);
  };
  const auto at = FirstPersistent(measured, out);
  if (!at) return {};
  const MotionSample& s = measured[*at];
  const Vector2 off = s.dcm_W - NearestPoint(s.support.polygon, s.dcm_W);
  return FailureEvent{
      Kind::kDcmOut, s.time_s,
      fmt::format("at {:.2f} s the DCM had left the support of {} by {:.0f} mm {}, out of reach of the next step",
                  s.time_s, NamesOf(in, s.stance), 1e3 * off.norm(), DirectionOf(off, YawOf(s.X_WB.linear())))};
}

Event BodyTouched(const ScoreInputs& in) {
  Event first;
  for (const BodyContact& contact : in.log.body_contacts) {
    if (first && first->time_s <= contact.time_s) continue;
    first = FailureEvent{Kind::kBodyContact, contact.time_s,
                         fmt::format("at {:.2f} s '{}' touched the ground", contact.time_s, contact.link)};
  }
  return first;
}

}  // namespace

namespace {

/// Events that are differences to a plan's contacts, or faults of the plan itself.
std::vector<Event> EventsOfPlan(const ScoreInputs& in) {
  const Event unstable = PlanUnstable(in), beyond_friction = PlanBeyondFriction(in);
  // With an unstable ZMP or forces beyond friction, no contact forces could be correct.
  const Event forces_off = unstable || beyond_friction ? Event() : PlanForcesOff(in);
  return {unstable,        PlanBeyondLimits(in), beyond_friction,   forces_off,
          ContactLost(in), EarlyContact(in),     MissedFoothold(in)};
}

}  // namespace

std::vector<FailureEvent> FailureEvents(const ScoreInputs& in) {
  const bool planned = PlansContacts(in.plan);
  std::vector<Event> all = planned ? EventsOfPlan(in) : std::vector<Event>();
  all.push_back(Slip(in));
  all.push_back(TorqueLimit(in));
  if (planned) all.push_back(DcmOut(in));
  all.push_back(BodyTouched(in));
  std::vector<FailureEvent> events;
  for (const Event& event : all) {
    if (event && event->time_s <= in.fall.time_s) events.push_back(*event);
  }
  std::stable_sort(events.begin(), events.end(),
                   [](const FailureEvent& a, const FailureEvent& b) { return a.time_s < b.time_s; });
  return events;
}

}  // namespace gaitwright
