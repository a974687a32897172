// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <vector>

#include "optimisation/pipeline/cool_motors_internal.h"
#include "optimisation/trajectory/motor_rows_internal.h"
#include "planning/audit/audit.h"

namespace gaitwright {

bool CoolMotors(const RobotModel& model, const MotionPlan& plan, BodyWeights& weights) {
  constexpr double kMore = 1.5, kMost = 1e3;  // of a weight
  const MotorRows rows(model, {});
  const std::vector<Actuator>& motors = rows.motors();
  if (std::ranges::none_of(motors, [](const Actuator& motor) { return std::isfinite(motor.motor.continuous_effort); }))
    return false;
  const Result<AuditReport> audit = Audit(model, plan, {});
  if (!audit) return false;
  weights.effort_of.resize(motors.size(), 1.0);
  bool hot = false;
  for (const Violation& v : audit->violations) {
    if (v.law != Law::kContinuousTorque) continue;
    const auto motor = std::ranges::find_if(motors, [&](const Actuator& m) { return m.name == v.where; });
    if (motor == motors.end()) continue;
    double& factor = weights.effort_of[static_cast<std::size_t>(motor - motors.begin())];
    hot = hot || factor < kMost;
    factor = std::min(kMost, factor * kMore * v.value / v.limit);
  }
  return hot;
}

}  // namespace gaitwright
