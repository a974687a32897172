// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>

namespace gaitwright {

/// Motor data of an independent coordinate: the data under `motors` in robot.yaml. Limits of position, speed and peak
/// effort are not included. Units are those of a revolute joint; for a prismatic joint N, m/s and kg.
///
/// Torque-speed curve: the peak effort up to `corner_speed`, from there linearly down to zero at `no_load_speed`, for
/// torque in the direction of motion; braking has the full peak.
struct Motor {
  static constexpr double kNone = std::numeric_limits<double>::infinity();

  double corner_speed = kNone;        ///< [rad/s]
  double no_load_speed = kNone;       ///< [rad/s]; above corner_speed, infinite without a curve
  double continuous_effort = kNone;   ///< largest root mean square of effort for an unlimited time [N m]
  double thermal_s = 10.0;            ///< averaging time of this mean [s]
  double rotor_inertia = 0.0;         ///< inertia of rotor and gear, reflected to the joint [kg m^2]
  double acceleration_limit = kNone;  ///< [rad/s^2]
  double jerk_limit = kNone;          ///< [rad/s^3]

  bool has_curve() const { return no_load_speed < kNone; }

  /// Largest torque at a speed, from 0 to `peak`.
  /// @param speed  speed in the direction of the torque; negative for braking.
  double EffortAt(double speed, double peak) const {
    if (!has_curve() || speed <= corner_speed) return peak;
    return speed >= no_load_speed ? 0.0 : peak * (no_load_speed - speed) / (no_load_speed - corner_speed);
  }
};

}  // namespace gaitwright
