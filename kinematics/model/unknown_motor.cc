// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/unknown_motor.h"

#include <cmath>

namespace gaitwright {

MotorBounds BoundsOfUnknownMotor(const RobotModel& model, int dof) {
  const double length_m = model.leg_length_m(), weight_n = model.weight_n();
  if (length_m == 0.0) return {Motor::kNone, Motor::kNone};
  if (model.LeaderOf(dof).is_prismatic()) return {10.0 * weight_n, 10.0 * std::sqrt(kGravity * length_m)};
  return {2.0 * weight_n * length_m, 20.0 * std::sqrt(kGravity / length_m)};
}

}  // namespace gaitwright
