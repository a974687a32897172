// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/motor_warmth.h"

#include <cmath>

namespace gaitwright {

double EffortWhenWarm(const Motor& motor, double mean_square, double peak) {
  const double c = motor.continuous_effort;
  if (!(c < peak) || mean_square <= kWarm * c * c) return peak;
  const double left = (c * c - mean_square) / ((1.0 - kWarm) * c * c);
  return left <= 0.0 ? c : c + (peak - c) * left;
}

double WarmthAfter(const Motor& motor, double mean_square, double effort, double time_s) {
  const double square = effort * effort;
  return square + (mean_square - square) * std::exp(-time_s / motor.thermal_s);
}

}  // namespace gaitwright
