// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/pipeline/limit_violation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "kinematics/model/actuator.h"
#include "kinematics/model/dof_units.h"

namespace gaitwright {
namespace {

/// Limit violations of a joint's position, and of the speed and effort of the motor with the same index; not positive
/// if the limits are kept.
struct LimitViolation {
  double position = 0.0, speed = 0.0, torque = 0.0;  ///< [rad, rad/s, N m] or [m, m/s, N]
};

LimitViolation ViolationOf(const RobotModel& model, const WholeBodyTrajectory& motion, const Actuator& motor, int dof,
                           double margin) {
  const double first = model.dof_lower(dof), last = model.dof_upper(dof), standing = model.standing_joints[dof];
  const double kept = std::isfinite(last - first) ? margin * (last - first) : 0.0;
  const double lower = std::min(first + kept, std::max(first, standing));
  const double upper = std::max(last - kept, std::min(last, standing));
  double low = upper, high = lower, speed = 0.0, torque = 0.0;
  for (std::size_t k = 0; k < motion.q.size(); ++k) {
    low = std::min(low, motion.q[k][7 + dof]);
    high = std::max(high, motion.q[k][7 + dof]);
    speed = std::max(speed, std::abs(motor.Speed(motion.v[k].tail(model.num_dofs()))));
    torque = std::max(torque, std::abs(motor.Effort(motion.tau[k])));
  }
  return {std::max({0.0, lower - low, high - upper}), std::max(0.0, speed - motor.velocity_limit),
          std::max(0.0, torque - motor.effort_limit)};
}

}  // namespace

double TotalViolation(const RobotModel& model, const WholeBodyTrajectory& motion, double margin) {
  double total = 0.0;
  for (int d = 0; d < model.num_dofs(); ++d) {
    const Actuator motor = ActuatorOf(model, d);
    const LimitViolation over = ViolationOf(model, motion, motor, d, margin);
    if (over.position > 0.0) total += over.position / std::max(model.dof_upper(d) - model.dof_lower(d), 1e-6);
    if (over.speed > 0.0) total += over.speed / std::max(motor.velocity_limit, 1e-6);
    if (over.torque > 0.0) total += over.torque / std::max(motor.effort_limit, 1e-6);
  }
  return total;
}

std::vector<std::string> LimitWarnings(const RobotModel& model, const WholeBodyTrajectory& motion) {
  std::vector<std::string> warnings;
  for (int d = 0; d < model.num_dofs(); ++d) {
    const Actuator motor = ActuatorOf(model, d);
    const LimitViolation over = ViolationOf(model, motion, motor, d, 0.0);
    const auto warn = [&](const std::string& name, double by, int decimals, const char* unit, const char* limit) {
      if (by > 0.0) warnings.push_back(fmt::format("{} is {:.{}f} {} {} limit", name, by, decimals, unit, limit));
    };
    warn(model.dof_names[static_cast<std::size_t>(d)], over.position, 3, PositionUnit(model, d), "past its");
    warn(motor.name, over.speed, 2, motor.speed_unit(), "over its speed");
    warn(motor.name, over.torque, 2, motor.effort_unit(), motor.slides ? "over its force" : "over its torque");
  }
  return warnings;
}

}  // namespace gaitwright
