// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/pipeline/fitted_options.h"

#include <algorithm>
#include <cmath>

namespace gaitwright {

RigidBodyOptions FittedOptions(const RobotModel& model, double flight_s, double rise_max_m_s,
                               RigidBodyOptions options) {
  constexpr double kOfFlight = 0.4, kFar = 0.075;  // kFar: share of the leg length
  constexpr double kLeg = 0.42;                    // [m]
  constexpr double kMostStance = 1e6;              // largest value of the option, for legs of millimetres
  const double thrown_m = 0.125 * kGravity * flight_s * flight_s, leg_m = model.leg_length_m();
  const double fitted = std::pow(kLeg / leg_m * std::min(1.0, kFar * leg_m / std::max(thrown_m, 1e-9)), 2);
  options.weights.stance = std::min(fitted * options.weights.stance, kMostStance);
  if (rise_max_m_s > 0.0) options.spacing_s = std::min(options.spacing_s, kOfFlight * 2.0 * rise_max_m_s / kGravity);
  return options;
}

}  // namespace gaitwright
