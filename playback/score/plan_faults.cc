// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "kinematics/dynamics/dynamics.h"
#include "kinematics/dynamics/foot_contact.h"
#include "kinematics/model/dof_units.h"
#include "playback/score/failure_events_internal.h"

namespace gaitwright {
namespace {

using Kind = FailureEvent::Kind;

constexpr double kOutsideArea = 0.002, kOutsideLine = 0.005;  // [m]
constexpr double kResidual = 0.05;                            // of m g, and of m g times the leg length

/// A quantity of the plan that exceeds its limit: its first time and its worst value.
struct PlannedViolation {
  double first_s = 0.0, worst = 0.0, limit = 0.0, over = 0.0;

  void See(double time_s, double value, double limit_now, double slack) {
    const double over_now = value - limit_now;
    if (!(over_now > slack)) return;
    if (over == 0.0) first_s = time_s;
    if (over_now <= over) return;
    over = over_now;
    worst = value;
    limit = limit_now;
  }
};

void Earlier(const PlannedViolation& violation, Kind kind, const std::string& text, Event& first) {
  if (violation.over <= 0.0 || (first && first->time_s <= violation.first_s)) return;
  first = FailureEvent{kind, violation.first_s, fmt::format("from {:.2f} s {}", violation.first_s, text)};
}

double LargestForce(const WholeBodySample& row) {
  double largest = row.tau.size() == 0 ? 0.0 : row.tau.cwiseAbs().maxCoeff();
  for (const ContactWrench& wrench : row.wrenches) largest = std::max(largest, wrench.force_W.norm());
  return largest;
}

/// Joint torques and total contact force, required by the motion and given by the plan.
struct Forces {
  VectorX needed_tau;
  Vector3 needed_W = Vector3::Zero(), given_W = Vector3::Zero();
};

Forces ForcesOf(const ScoreInputs& in, const WholeBodySample& row, DynamicsScratch& scratch) {
  Forces forces;
  VectorX needed;
  InverseDynamics(in.model, row.q, row.v, row.a, scratch, needed);
  forces.needed_W = needed.head<3>();
  for (std::size_t f = 0; f < row.wrenches.size(); ++f) {
    const Vector3 origin = ContactFrame(in.model, scratch, in.plan.terrain, static_cast<int>(f)).translation();
    Vector6 w;
    w << -row.wrenches[f].force_W, -row.wrenches[f].moment_W;
    AddPointWrench(in.model, scratch, in.model.feet[f].body, origin, w, needed);
    forces.given_W += row.wrenches[f].force_W;
  }
  forces.needed_tau = needed.tail(in.model.num_dofs());
  return forces;
}

}  // namespace

Event PlanUnstable(const ScoreInputs& in) {
  const auto& planned = in.series.planned;
  const auto outside = [&](std::size_t k) {
    const double limit = HasArea(planned[k].support) ? kOutsideArea : kOutsideLine;
    return planned[k].has_zmp && planned[k].zmp_margin_m() < -limit;
  };
  const auto at = FirstPersistent(planned, outside);
  if (!at) return {};
  double worst = 0.0;
  for (std::size_t k = *at; k < planned.size() && outside(k); ++k) worst = std::min(worst, planned[k].zmp_margin_m());
  const MotionSample& s = planned[*at];
  return FailureEvent{
      Kind::kPlanUnstable, s.time_s,
      fmt::format("from {:.2f} s the plan itself has its ZMP outside the support of {}, by up to {:.0f} mm", s.time_s,
                  NamesOf(in, s.stance), -1e3 * worst)};
}

Event PlanBeyondLimits(const ScoreInputs& in) {
  constexpr double kSlack = 1e-3;  // [rad], share of the torque
  Event first;
  for (int i = 0; i < in.model.num_dofs(); ++i) {
    PlannedViolation position, torque;
    const Actuator& motor = in.motors[static_cast<std::size_t>(i)];
    const double limit = motor.effort_limit;
    for (std::size_t k = 0; k < in.series.plan.size(); ++k) {
      const WholeBodySample& row = in.series.plan[k];
      const double time = in.series.planned[k].time_s, q = row.q[7 + i];
      position.See(time, std::max(in.model.dof_lower(i) - q, q - in.model.dof_upper(i)), 0.0, kSlack);
      if (HasTorqueLimit(motor) && row.tau.size() == in.model.num_dofs())
        torque.See(time, std::abs(motor.Effort(row.tau)), limit, kSlack * limit);
    }
    const std::string& name = in.model.dof_names[static_cast<std::size_t>(i)];
    Earlier(position, Kind::kPlanBeyondLimits,
            fmt::format("the plan itself moves '{}' past its limit, by up to {:.3f} {}", name, position.worst,
                        PositionUnit(in.model, i)),
            first);
    Earlier(torque, Kind::kPlanBeyondLimits,
            fmt::format("the plan itself needs up to {0:.2f} {3} from '{1}', whose limit is {2:.2f} {3}", torque.worst,
                        motor.name, limit, motor.effort_unit()),
            first);
  }
  return first;
}

Event PlanBeyondFriction(const ScoreInputs& in) {
  const double slack = 1e-3 * in.model.weight_n();
  Event first;
  for (std::size_t f = 0; f < in.model.feet.size(); ++f) {
    PlannedViolation sideways;
    for (std::size_t k = 0; k < in.series.plan.size(); ++k) {
      if (f >= in.series.plan[k].wrenches.size()) continue;
      const MotionSample& s = in.series.planned[k];
      const GroundPoint ground = GroundAt(in.plan.terrain, s.feet[f].p_WF.head<2>());
      const Vector3& force = in.series.plan[k].wrenches[f].force_W;
      const double normal = force.dot(ground.normal_W);
      sideways.See(s.time_s, (force - normal * ground.normal_W).norm(), ground.friction * std::max(normal, 0.0), slack);
    }
    Earlier(sideways, Kind::kPlanBeyondFriction,
            fmt::format(
                "the plan itself needs a tangential force of up to {1:.1f} N at '{0}', but friction allows {2:.1f} N",
                FootName(in, static_cast<int>(f)), sideways.worst, sideways.limit),
            first);
  }
  return first;
}

Event PlanForcesOff(const ScoreInputs& in) {
  const double force_limit = kResidual * in.model.weight_n(), torque_limit = force_limit * in.leg_length_m;
  DynamicsScratch scratch(in.model);
  double largest = 0.0;
  for (const WholeBodySample& row : in.series.plan) largest = std::max(largest, LargestForce(row));
  if (largest == 0.0) return {};
  std::vector<Forces> all;
  for (const WholeBodySample& row : in.series.plan) all.push_back(ForcesOf(in, row, scratch));
  Eigen::Index joint = 0;
  const auto torque_off = [&](std::size_t k) {
    const VectorX& tau = in.series.plan[k].tau;
    return tau.size() == 0 ? 0.0 : (tau - all[k].needed_tau).cwiseAbs().maxCoeff(&joint);
  };
  const auto force_off = [&](std::size_t k) { return (all[k].given_W - all[k].needed_W).norm(); };
  const auto& planned = in.series.planned;
  const auto at = FirstPersistent(
      planned, [&](std::size_t k) { return force_off(k) > force_limit || torque_off(k) > torque_limit; });
  if (!at) return {};
  std::string text;
  if (force_off(*at) > force_limit) {
    text = fmt::format("contact forces do not match its motion: {:.0f} N in all, needed {:.0f} N",
                       all[*at].given_W.norm(), all[*at].needed_W.norm());
  } else {
    torque_off(*at);
    text = fmt::format("torques do not match its motion: '{0}' has {1:.2f} {3}, needed {2:.2f} {3}",
                       in.model.dof_names[static_cast<std::size_t>(joint)], in.series.plan[*at].tau[joint],
                       all[*at].needed_tau[joint], EffortUnit(in.model, static_cast<int>(joint)));
  }
  return FailureEvent{Kind::kPlanForcesOff, planned[*at].time_s,
                      fmt::format("from {:.2f} s the plan's {}", planned[*at].time_s, text)};
}

}  // namespace gaitwright
