// SPDX-License-Identifier: BSD-3-Clause
#include "planning/audit/joint_watch.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "kinematics/model/dof_units.h"
#include "planning/audit/tolerances.h"

namespace gaitwright {

using tolerance::kRelative;

JointWatch::JointWatch(const RobotModel& model, const AuditOptions& options, int samples, Findings& findings)
    : model_(model),
      options_(options),
      findings_(findings),
      effort_(model),
      jerk_steps_(static_cast<std::size_t>(std::max(1L, std::lround(options.jerk_over_s * options.rate_hz)))) {
  for (int d = 0; d < model.num_dofs(); ++d) joints_.push_back(Watch(d, samples));
}

JointWatch::Watched JointWatch::Watch(int dof, int samples) {
  const std::string& name = model_.dof_names[static_cast<std::size_t>(dof)];
  const Actuator& actuator = effort_.motors()[static_cast<std::size_t>(dof)];
  const Motor& motor = actuator.motor;
  const std::string of_position = PositionUnit(model_, dof), of_effort = actuator.effort_unit();
  Watched joint = {};
  joint.lower = model_.dof_lower(dof);
  joint.upper = model_.dof_upper(dof);
  joint.position_scale_lower = kRelative * std::max(1.0, std::abs(joint.lower));
  joint.position_scale_upper = kRelative * std::max(1.0, std::abs(joint.upper));
  joint.speed = options_.derate_speed * actuator.velocity_limit;
  joint.acceleration = options_.derate_acceleration * model_.MotorOf(dof).acceleration_limit;
  joint.jerk = options_.derate_jerk * model_.MotorOf(dof).jerk_limit;
  joint.effort = options_.derate_torque * actuator.effort_limit;
  joint.continuous = options_.derate_continuous * motor.continuous_effort;
  joint.position = findings_.Place(Law::kJointPosition, name, of_position);
  joint.velocity = findings_.Place(Law::kJointVelocity, actuator.name, actuator.speed_unit());
  joint.accelerated = findings_.Place(Law::kJointAcceleration, name, of_position + "/s^2");
  joint.jerked = findings_.Place(Law::kJointJerk, name, of_position + "/s^3");
  joint.torque = findings_.Place(Law::kJointTorque, actuator.name, of_effort);
  joint.curve = findings_.Place(Law::kTorqueSpeed, actuator.name, of_effort);
  joint.heat = findings_.Place(Law::kContinuousTorque, actuator.name, of_effort);
  if (std::isfinite(joint.jerk)) joint.accelerations.assign(jerk_steps_, 0.0);
  if (std::isfinite(joint.continuous)) {
    const double steps = std::min(std::round(motor.thermal_s * options_.rate_hz), static_cast<double>(samples));
    joint.window = std::max<std::size_t>(1, static_cast<std::size_t>(steps));
    joint.squares.assign(joint.window, 0.0);
  }
  return joint;
}

void JointWatch::Look(const WholeBodySample& sample, double time_s) {
  const Eigen::Index n = model_.num_dofs();
  for (int d = 0; d < model_.num_dofs(); ++d) {
    Watched& joint = joints_[static_cast<std::size_t>(d)];
    const Actuator& actuator = effort_.motors()[static_cast<std::size_t>(d)];
    const double speed = actuator.Speed(sample.v.tail(n));
    const double effort = effort_.Of(d, sample.tau, sample.v.tail(n), sample.a.tail(n));
    LookAtMotion(joint, sample.q[7 + d], speed, sample.a[6 + d], time_s);
    LookAtEffort(joint, actuator.motor, effort, speed, time_s);
    LookAtHeat(joint, effort, time_s);
  }
  ++count_;
}

void JointWatch::LookAtMotion(Watched& joint, double q, double motor_speed, double a, double time_s) {
  findings_.Hold(joint.position, time_s, q, joint.lower, q - joint.lower, joint.position_scale_lower);
  findings_.Hold(joint.position, time_s, q, joint.upper, joint.upper - q, joint.position_scale_upper);
  const double speed = std::abs(motor_speed), size = std::abs(a);
  findings_.Hold(joint.velocity, time_s, speed, joint.speed, joint.speed - speed, kRelative * joint.speed);
  findings_.Hold(joint.accelerated, time_s, size, joint.acceleration, joint.acceleration - size,
                 kRelative * joint.acceleration);
  if (joint.accelerations.empty()) return;
  double& before = joint.accelerations[count_ % jerk_steps_];
  if (count_ >= jerk_steps_) {
    const double over_s = static_cast<double>(jerk_steps_) / options_.rate_hz, jerk = std::abs(a - before) / over_s;
    findings_.Hold(joint.jerked, time_s - 0.5 * over_s, jerk, joint.jerk, joint.jerk - jerk, kRelative * joint.jerk);
  }
  before = a;
}

/// Up to the corner speed of the curve, and while the motor brakes, the limit is the peak effort. The margin to it is
/// noted for the curve, too.
void JointWatch::LookAtEffort(Watched& joint, const Motor& motor, double effort, double v, double time_s) {
  const double size = std::abs(effort);
  findings_.Hold(joint.torque, time_s, size, joint.effort, joint.effort - size, kRelative * joint.effort);
  if (!motor.has_curve()) return;
  const double speed = std::abs(v) / options_.derate_speed;
  if (speed <= motor.corner_speed || effort * v <= 0.0) {
    findings_.Near(joint.curve, time_s, size, joint.effort, joint.effort - size);
    return;
  }
  const double limit = motor.EffortAt(speed, joint.effort);
  findings_.Hold(joint.curve, time_s, size, limit, limit - size, kRelative * limit);
}

void JointWatch::LookAtHeat(Watched& joint, double effort, double time_s) {
  if (joint.squares.empty()) return;
  double& oldest = joint.squares[count_ % joint.window];
  joint.sum += effort * effort - oldest;
  oldest = effort * effort;
  if (count_ + 1 < joint.window) return;
  const double mean = std::sqrt(std::max(joint.sum, 0.0) / static_cast<double>(joint.window));
  findings_.Hold(joint.heat, time_s, mean, joint.continuous, joint.continuous - mean, kRelative * joint.continuous);
}

/// If samples were left out, windows as long as the plan are not full.
void JointWatch::Finish(double time_s) {
  for (Watched& joint : joints_) {
    if (joint.squares.empty() || count_ >= joint.window || count_ == 0) continue;
    const double mean = std::sqrt(std::max(joint.sum, 0.0) / static_cast<double>(count_));
    findings_.Hold(joint.heat, time_s, mean, joint.continuous, joint.continuous - mean, kRelative * joint.continuous);
  }
}

std::vector<std::string> UnknownOfMotors(const RobotModel& model) {
  struct Known {
    Law law;
    const char* what;
    bool of_joint;  // true: a joint's limit; false: a motor's limit
    bool (*of)(const Motor&);
  };
  const Known all[] = {
      {Law::kJointAcceleration, "limit of acceleration", true,
       [](const Motor& m) { return std::isfinite(m.acceleration_limit); }},
      {Law::kJointJerk, "limit of jerk", true, [](const Motor& m) { return std::isfinite(m.jerk_limit); }},
      {Law::kTorqueSpeed, "torque-speed curve", false, [](const Motor& m) { return m.has_curve(); }},
      {Law::kContinuousTorque, "continuous torque", false,
       [](const Motor& m) { return std::isfinite(m.continuous_effort); }}};
  const std::vector<Actuator> motors = ActuatorsOf(model);
  std::vector<std::string> lines;
  for (const Known& known : all) {
    std::vector<std::string> without;
    for (int d = 0; d < model.num_dofs(); ++d) {
      const Actuator& motor = motors[static_cast<std::size_t>(d)];
      if (!known.of(known.of_joint ? model.MotorOf(d) : motor.motor))
        without.push_back(known.of_joint ? model.dof_names[static_cast<std::size_t>(d)] : motor.name);
    }
    if (without.empty()) continue;
    const bool none = static_cast<int>(without.size()) == model.num_dofs();
    lines.push_back(fmt::format("{} not applied{}: robot.yaml does not give {} {}", LawName(known.law),
                                none ? "" : fmt::format(" to {}", QuotedList(without)), none ? "any" : "their",
                                known.what));
  }
  std::vector<std::string> endless;
  for (const Actuator& motor : motors) {
    if (motor.motor.has_curve() && !std::isfinite(motor.effort_limit)) endless.push_back(motor.name);
  }
  if (!endless.empty()) {
    lines.push_back(fmt::format(
        "torque_speed not applied to {} below the no-load speed: the peak torque of the curve is a placeholder",
        QuotedList(endless)));
  }
  return lines;
}

}  // namespace gaitwright
