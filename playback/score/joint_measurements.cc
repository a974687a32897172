// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>

#include "planning/plan/plans_contacts_internal.h"
#include "playback/score/measurements.h"

namespace gaitwright {

bool HasTorqueLimit(const Actuator& motor) { return std::isfinite(motor.effort_limit) && motor.effort_limit > 0.0; }

bool MayBeAtALimit(const Actuator& motor) {
  return HasTorqueLimit(motor) || std::isfinite(motor.motor.continuous_effort) || motor.motor.has_curve();
}

namespace {

constexpr double kAtLimit = 1e-6;  // [rad] or [m]

const char* const kNoTorqueLimit = "no joint has a torque limit other than a placeholder";

bool HasSpeedLimit(const Actuator& motor) { return std::isfinite(motor.velocity_limit) && motor.velocity_limit > 0.0; }

/// Joints that the plan holds still are excluded, since they may rest at a limit (a closed hand, a stretched arm). A
/// command plans no posture; all joints that moved count.
bool Moves(const ScoreInputs& in, int dof) {
  constexpr double kStill = 1e-3;  // [rad] or [m]
  const bool planned = PlansContacts(in.plan);
  const auto position = [&](std::size_t k) {
    return planned ? in.series.plan[k].q[7 + dof] : in.log.samples[k].q[7 + dof];
  };
  double least = position(0), most = least;
  for (std::size_t k = 0; k < in.series.plan.size(); ++k) {
    least = std::min(least, position(k));
    most = std::max(most, position(k));
  }
  return most - least > kStill;
}

/// Distance to the lower limit; infinite if the joint stands at this limit, where it may rest.
double RoomBelow(const RobotModel& model, int dof, double position) {
  const bool rests = model.standing_joints[dof] - model.dof_lower(dof) < kAtLimit;
  return rests ? std::numeric_limits<double>::infinity() : position - model.dof_lower(dof);
}

/// The same for the upper limit.
double RoomAbove(const RobotModel& model, int dof, double position) {
  const bool rests = model.dof_upper(dof) - model.standing_joints[dof] < kAtLimit;
  return rests ? std::numeric_limits<double>::infinity() : model.dof_upper(dof) - position;
}

/// Extremes over time of quantities of joints and motors, for plan and log.
struct JointExtremes {
  Extreme speed{Extreme::Kind::kLargest}, margin{Extreme::Kind::kSmallest};

  std::vector<bool> moves;  ///< by joint

  void See(const ScoreInputs& in, const VectorX& q, const VectorX& v, double time_s) {
    const RobotModel& model = in.model;
    for (int i = 0; i < model.num_dofs(); ++i) {
      const Actuator& motor = in.motors[static_cast<std::size_t>(i)];
      if (HasSpeedLimit(motor))
        speed.See(std::abs(motor.Speed(v.tail(model.num_dofs()))) / motor.velocity_limit, time_s);
      const double room = std::min(RoomBelow(model, i, q[7 + i]), RoomAbove(model, i, q[7 + i]));
      if (moves[static_cast<std::size_t>(i)] && std::isfinite(room)) margin.See(room, time_s);
    }
  }
};

/// Measured torque relative to the limit at that time, planned torque relative to the robot's limit.
Measurement TorqueUse(const ScoreInputs& in) {
  Extreme measured(Extreme::Kind::kLargest), planned(Extreme::Kind::kLargest);
  for (std::size_t k = 0; k < in.series.measured.size(); ++k) {
    const LogSample& sample = in.log.samples[k];
    const VectorX& wanted = in.series.plan[k].tau;
    for (int i = 0; i < in.model.num_dofs(); ++i) {
      const Actuator& motor = in.motors[static_cast<std::size_t>(i)];
      if (HasTorqueLimit(motor) || sample.effort_use[i] > 0.0) measured.See(sample.effort_use[i], sample.time_s);
      if (HasTorqueLimit(motor) && wanted.size() == in.model.num_dofs())
        planned.See(std::abs(motor.Effort(wanted)) / motor.effort_limit, sample.time_s);
    }
  }
  return FromExtremes("torque_use_max", measured, planned, kNoTorqueLimit);
}

Measurement Saturated(const ScoreInputs& in) {
  const double duration = in.log.samples.back().time_s - in.log.start_s;
  Extreme largest(Extreme::Kind::kLargest);
  for (int i = 0; i < std::min(in.model.num_dofs(), static_cast<int>(in.log.saturated_s.size())); ++i) {
    if (MayBeAtALimit(in.motors[static_cast<std::size_t>(i)]) && duration > 0.0)
      largest.See(in.log.saturated_s[i] / duration, 0.0);
  }
  if (!largest.value) return {"torque_saturated_fraction", {}, {}, {}, kNoTorqueLimit};
  return {"torque_saturated_fraction", *largest.value, {}, {}, ""};
}

double PositiveWork(double step_s, const VectorX& tau, const VectorX& v) {
  double power = 0.0;
  for (Eigen::Index i = 0; i < tau.size(); ++i) power += std::max(tau[i] * v[6 + i], 0.0);
  return power * step_s;
}

Measurement CostOfTransport(const ScoreInputs& in) {
  constexpr double kLeastShareOfLeg = 0.25;
  const auto& [planned, measured, plan] = in.series;
  const auto distance = [](const std::vector<MotionSample>& samples) {
    return (samples.back().X_WB.translation() - samples.front().X_WB.translation()).head<2>().norm();
  };
  if (std::min(distance(measured), distance(planned)) < kLeastShareOfLeg * in.leg_length_m) {
    return {"cost_of_transport", {}, {}, {}, "the robot moved less than a quarter of its leg length"};
  }
  double planned_work = 0.0;
  for (std::size_t k = 1; k < measured.size(); ++k) {
    const double step = measured[k].time_s - measured[k - 1].time_s;
    if (plan[k].tau.size() == in.model.num_dofs()) planned_work += PositiveWork(step, plan[k].tau, plan[k].v);
  }
  const double weight = in.model.weight_n(), work = PositiveWork(in.log, measured.size());
  return {
      "cost_of_transport", work / (weight * distance(measured)), planned_work / (weight * distance(planned)), {}, ""};
}

/// Second difference of joint rates, squared and summed over the joints, and the time of its maximum.
Measurement Jerk(const ScoreInputs& in) {
  const auto& samples = in.log.samples;
  const std::size_t count = in.series.measured.size();
  const Eigen::Index n = in.model.num_dofs();
  if (count < 3 || n == 0) return {"smoothness_jerk_rms", {}, {}, {}, "fewer than three samples or no joints"};
  const double h = 1.0 / in.log.log_rate_hz;
  const auto square = [&](const VectorX& a, const VectorX& b, const VectorX& c) {
    return ((a - 2.0 * b + c).tail(n) / (h * h)).squaredNorm();
  };
  double sum = 0.0, planned = 0.0;
  Extreme largest(Extreme::Kind::kLargest);
  for (std::size_t k = 1; k + 1 < count; ++k) {
    const double now = square(samples[k - 1].v, samples[k].v, samples[k + 1].v);
    sum += now;
    planned += square(in.series.plan[k - 1].v, in.series.plan[k].v, in.series.plan[k + 1].v);
    largest.See(now, samples[k].time_s);
  }
  const double terms = static_cast<double>(count - 2) * static_cast<double>(n);
  return {"smoothness_jerk_rms", std::sqrt(sum / terms), std::sqrt(planned / terms), largest.at_s, ""};
}

/// Largest change of a motor's torque between log intervals, within two intervals of a contact switch of the schedule.
Measurement TorqueStep(const ScoreInputs& in) {
  const double near = 2.0 / in.log.log_rate_hz;
  Extreme measured(Extreme::Kind::kLargest), planned(Extreme::Kind::kLargest);
  const auto see = [&](const VectorX& before, const VectorX& now, double time_s, Extreme& largest) {
    for (const Actuator& motor : in.motors) {
      if (HasTorqueLimit(motor) && now.size() == in.model.num_dofs() && before.size() == now.size())
        largest.See(std::abs(motor.Effort(now - before)) / motor.effort_limit, time_s);
    }
  };
  const auto& phases = in.plan.schedule.phases;
  for (std::size_t k = 1; k < in.series.measured.size(); ++k) {
    const double time = in.log.samples[k].time_s;
    const bool at_switch = std::any_of(phases.begin() + (phases.empty() ? 0 : 1), phases.end(),
                                       [&](const ContactPhase& p) { return std::abs(time - p.start_s) <= near; });
    if (!at_switch) continue;
    see(in.log.samples[k - 1].tau, in.log.samples[k].tau, time, measured);
    see(in.series.plan[k - 1].tau, in.series.plan[k].tau, time, planned);
  }
  return FromExtremes("torque_step_use_max", measured, planned, "no contact switches, or no torque limits");
}

}  // namespace

double PositiveWork(const PlaybackLog& log, std::size_t samples) {
  double work = 0.0;
  for (std::size_t k = 1; k < samples; ++k) {
    const LogSample& sample = log.samples[k];
    work += PositiveWork(sample.time_s - log.samples[k - 1].time_s, sample.tau, sample.v);
  }
  return work;
}

std::vector<Measurement> JointMeasurements(const ScoreInputs& in) {
  JointExtremes measured, planned;
  for (int i = 0; i < in.model.num_dofs(); ++i) measured.moves.push_back(Moves(in, i));
  planned.moves = measured.moves;
  for (std::size_t k = 0; k < in.series.measured.size(); ++k) {
    const LogSample& sample = in.log.samples[k];
    const WholeBodySample& wanted = in.series.plan[k];
    measured.See(in, sample.q, sample.v, sample.time_s);
    planned.See(in, wanted.q, wanted.v, sample.time_s);
  }
  return {TorqueUse(in),
          Saturated(in),
          FromExtremes("joint_speed_use_max", measured.speed, planned.speed,
                       "no joint has a speed limit other than a placeholder"),
          FromExtremes("joint_limit_margin_min_rad", measured.margin, planned.margin,
                       "no joint with position limits moves"),
          CostOfTransport(in),
          Jerk(in),
          TorqueStep(in)};
}

}  // namespace gaitwright
