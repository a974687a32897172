// SPDX-License-Identifier: BSD-3-Clause
#include "playback/sensing/sensor_options.h"

#include <fmt/format.h>

#include <algorithm>

#include "kinematics/spatial/pose.h"

namespace gaitwright {
namespace {

constexpr double kFastest = 1e5;  // [Hz]

OptionFields EncoderFields(SensorOptions& o) {
  return {
      {"encoder_noise_rad", &o.encoder_noise_rad, "rad", 0.0, 0.1, "White noise of a reading of a joint.", {}},
      {"encoder_bias_rad", &o.encoder_bias_rad, "rad", 0.0, 0.1, "Zero of each joint is off within +- this.", {}},
      {"encoder_resolution_rad",
       &o.encoder_resolution_rad,
       "rad",
       0.0,
       0.1,
       "Step in which joints are read; 0: exact.",
       {}},
      {"encoder_rate_hz",
       &o.encoder_rate_hz,
       "Hz",
       0.0,
       kFastest,
       "Readings per second, in whole time steps; 0: one a step.",
       {}},
      {"encoder_delay_s",
       &o.encoder_delay_s,
       "s",
       0.0,
       kLongestDelay,
       "Age of a reading when the controller has it, in whole time steps.",
       {}},
      {"speed_cutoff_hz",
       &o.speed_cutoff_hz,
       "Hz",
       0.0,
       kFastest,
       "Band of the critically damped tracking filter that has speeds, and smooth positions, from readings of "
       "positions; 0: the difference of two readings.",
       {}},
  };
}

OptionFields ImuFields(SensorOptions& o) {
  return {
      {"gyroscope_noise_rad_s_sqrt_hz",
       &o.gyroscope_noise_rad_s_sqrt_hz,
       "rad/s/sqrt(Hz)",
       0.0,
       1.0,
       "White noise of the gyroscope, as a density.",
       {}},
      {"gyroscope_bias_rad_s", &o.gyroscope_bias_rad_s, "rad/s", 0.0, 1.0, "Magnitude of its bias at the start.", {}},
      {"gyroscope_walk_rad_s2_sqrt_hz",
       &o.gyroscope_walk_rad_s2_sqrt_hz,
       "rad/s^2/sqrt(Hz)",
       0.0,
       1.0,
       "Random walk of that bias, as a density.",
       {}},
      {"gyroscope_cutoff_hz",
       &o.gyroscope_cutoff_hz,
       "Hz",
       0.0,
       kFastest,
       "First-order low-pass of the angular velocity that the controller gets; the estimate of attitude has all of the "
       "readings; 0: none.",
       {}},
      {"accelerometer_noise_m_s2_sqrt_hz",
       &o.accelerometer_noise_m_s2_sqrt_hz,
       "m/s^2/sqrt(Hz)",
       0.0,
       10.0,
       "White noise of the accelerometer, as a density.",
       {}},
      {"accelerometer_bias_m_s2",
       &o.accelerometer_bias_m_s2,
       "m/s^2",
       0.0,
       10.0,
       "Magnitude of its bias at the start.",
       {}},
      {"accelerometer_walk_m_s3_sqrt_hz",
       &o.accelerometer_walk_m_s3_sqrt_hz,
       "m/s^3/sqrt(Hz)",
       0.0,
       10.0,
       "Random walk of that bias, as a density.",
       {}},
      {"imu_rate_hz",
       &o.imu_rate_hz,
       "Hz",
       0.0,
       kFastest,
       "Readings per second, in whole time steps, each the mean since the one before; 0: one a step.",
       {}},
      {"imu_delay_s",
       &o.imu_delay_s,
       "s",
       0.0,
       kLongestDelay,
       "Age of a reading when the controller has it, in whole time steps.",
       {}},
  };
}

OptionFields ContactFields(SensorOptions& o) {
  return {
      {"contact_threshold",
       &o.contact_threshold,
       "1",
       0.0,
       1.0,
       "Share of the robot's weight above which a foot tells of contact.",
       {}},
      {"contact_noise",
       &o.contact_noise,
       "1",
       0.0,
       1.0,
       "White noise of a foot's normal force, as a share of the robot's weight.",
       {}},
      {"contact_rate_hz",
       &o.contact_rate_hz,
       "Hz",
       0.0,
       kFastest,
       "Readings per second, in whole time steps; 0: one a step.",
       {}},
      {"contact_delay_s",
       &o.contact_delay_s,
       "s",
       0.0,
       kLongestDelay,
       "Age of a reading when the controller has it, in whole time steps.",
       {}},
      {"contact_missed", &o.contact_missed, "1", 0.0, 1.0, "Share of readings in contact that tell of none.", {}},
      {"contact_false", &o.contact_false, "1", 0.0, 1.0, "Share of readings in the air that tell of contact.", {}},
  };
}

/// The place of a name in a list. @throws InvalidArgument listing them.
std::size_t PlaceOf(const std::string& name, const std::vector<std::string>& names, const char* what) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end())
    throw InvalidArgument(fmt::format("there is no {} '{}'; there are {}", what, name, QuotedList(names)));
  return static_cast<std::size_t>(found - names.begin());
}

/// An IMU and encoders as in robots for research.
SensorOptions GoodSensors() {
  SensorOptions o;
  o.encoder_noise_rad = 2e-4;
  o.encoder_resolution_rad = 1e-4;
  o.speed_cutoff_hz = 80.0;
  o.gyroscope_noise_rad_s_sqrt_hz = 2e-4;
  o.gyroscope_bias_rad_s = 1e-3;
  o.gyroscope_walk_rad_s2_sqrt_hz = 1e-5;
  o.gyroscope_cutoff_hz = 100.0;
  o.accelerometer_noise_m_s2_sqrt_hz = 2e-4 * kGravity;
  o.accelerometer_bias_m_s2 = 2e-3 * kGravity;
  o.accelerometer_walk_m_s3_sqrt_hz = 1e-5 * kGravity;
  o.imu_delay_s = 0.001;
  o.contact_threshold = 0.02;
  o.contact_noise = 0.005;
  o.contact_delay_s = 0.001;
  return o;
}

/// What a small budget buys.
SensorOptions HobbySensors() {
  SensorOptions o;
  o.encoder_noise_rad = 1e-3;
  o.speed_cutoff_hz = 50.0;
  o.gyroscope_noise_rad_s_sqrt_hz = 5e-3;
  o.gyroscope_bias_rad_s = 0.01;
  o.gyroscope_walk_rad_s2_sqrt_hz = 1e-4;
  o.gyroscope_cutoff_hz = 40.0;
  o.accelerometer_noise_m_s2_sqrt_hz = 3e-3 * kGravity;
  o.accelerometer_bias_m_s2 = 0.02 * kGravity;
  o.accelerometer_walk_m_s3_sqrt_hz = 1e-4 * kGravity;
  o.imu_delay_s = 0.001;
  o.contact_threshold = 0.03;
  o.contact_noise = 0.01;
  o.contact_missed = 0.002;
  o.contact_false = 0.002;
  return o;
}

}  // namespace

OptionFields SensorOptions::Fields() {
  return Joined({EncoderFields(*this),
                 ImuFields(*this),
                 ContactFields(*this),
                 {{"seed", &seed, "1", 0, 2147483647, "Of all their noise and biases.", {}}}});
}

const std::vector<std::string>& SensorKinds() {
  static const std::vector<std::string> names = {"ideal", "good", "hobby"};
  return names;
}

SensorOptions SensorsOfKind(const std::string& name) {
  switch (PlaceOf(name, SensorKinds(), "set of sensors")) {
    case 1:
      return GoodSensors();
    case 2:
      return HobbySensors();
    default:
      return {};
  }
}

const std::vector<std::string>& StateSourceNames() {
  static const std::vector<std::string> names = {"true", "measured", "estimated"};
  return names;
}

StateSource StateSourceOf(const std::string& name) {
  return static_cast<StateSource>(PlaceOf(name, StateSourceNames(), "source of the state"));
}

const std::vector<std::string>& DriveLoopNames() {
  static const std::vector<std::string> names = {"own", "sensed"};
  return names;
}

DriveLoop DriveLoopOf(const std::string& name) {
  return static_cast<DriveLoop>(PlaceOf(name, DriveLoopNames(), "loop of the drives"));
}

}  // namespace gaitwright
