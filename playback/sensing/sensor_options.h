// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/base/options.h"

namespace gaitwright {

/// Errors of sensors. All zero, the default, means perfect sensors.
///
/// White noise of an IMU is given as a density, as in data sheets: at f readings per second a reading has the standard
/// deviation density * sqrt(f), so that its integral over a time T has density * sqrt(T) at any rate. Biases are drawn
/// once per seed: of a joint uniformly within +- the value, of an IMU in a random direction with that magnitude. Values
/// of encoders are in radians, for prismatic joints in metres.
///
/// Tuning
///   the robot shakes on its legs       lower speed_cutoff_hz, gyroscope_cutoff_hz
///   the robot reacts late to pushes    raise speed_cutoff_hz, gyroscope_cutoff_hz
struct SensorOptions {
  double encoder_noise_rad = 0.0;
  double encoder_bias_rad = 0.0;
  double encoder_resolution_rad = 0.0;
  double encoder_rate_hz = 0.0;
  double encoder_delay_s = 0.0;
  double speed_cutoff_hz = 0.0;
  double gyroscope_noise_rad_s_sqrt_hz = 0.0;
  double gyroscope_bias_rad_s = 0.0;
  double gyroscope_walk_rad_s2_sqrt_hz = 0.0;
  double gyroscope_cutoff_hz = 0.0;
  double accelerometer_noise_m_s2_sqrt_hz = 0.0;
  double accelerometer_bias_m_s2 = 0.0;
  double accelerometer_walk_m_s3_sqrt_hz = 0.0;
  double imu_rate_hz = 0.0;
  double imu_delay_s = 0.0;
  double contact_threshold = 0.0;
  double contact_noise = 0.0;
  double contact_rate_hz = 0.0;
  double contact_delay_s = 0.0;
  double contact_missed = 0.0;
  double contact_false = 0.0;
  int seed = 0;

  OptionFields Fields();

  bool operator==(const SensorOptions&) const = default;
};

/// Longest delay of a sensor or a command [s].
inline constexpr double kLongestDelay = 0.1;

/// Names of ready-made sets: "ideal", "good", "hobby".
const std::vector<std::string>& SensorKinds();

/// The values of a predefined set; docs/sensing.md gives their sources.
/// @throws InvalidArgument listing the known names.
SensorOptions SensorsOfKind(const std::string& name);

/// Source of the robot's state for a controller.
enum class StateSource {
  kTrue,       ///< the simulator
  kMeasured,   ///< joints and contacts from their sensors, the base from the simulator, as with motion capture
  kEstimated,  ///< joints and contacts from their sensors, the base by LegOdometry
};

/// State that the stiffness and damping of a command act on.
enum class DriveLoop {
  kOwn,     ///< the joint as read by the drive's own encoder: without delay, except for a zero offset
  kSensed,  ///< the controller's sensed state; the command becomes a torque
};

/// "own", "sensed": in the order of DriveLoop.
const std::vector<std::string>& DriveLoopNames();

/// @throws InvalidArgument listing the known names.
DriveLoop DriveLoopOf(const std::string& name);

/// "true", "measured", "estimated": in the order of StateSource.
const std::vector<std::string>& StateSourceNames();

/// @throws InvalidArgument listing the known names.
StateSource StateSourceOf(const std::string& name);

}  // namespace gaitwright
