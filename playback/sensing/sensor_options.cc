// SPDX-License-Identifier: BSD-3-Clause
#include "playback/sensing/sensor_options.h"

#include <fmt/format.h>

#include <algorithm>

#include "kinematics/spatial/pose.h"

namespace gaitwright {
namespace {

constexpr double kFastest = 1e5;  // [Hz]

OptionFields EncoderFields(SensorOptions& o) {
  return WithBasics(
      {"encoder_noise_rad", "encoder_delay_s"},
      {
          {"encoder_noise_rad", &o.encoder_noise_rad, "rad", 0.0, 0.1,
           "Standard deviation of the white noise of a joint encoder."},
          {"encoder_bias_rad", &o.encoder_bias_rad, "rad", 0.0, 0.1,
           "Zero offset of each joint encoder, drawn uniformly within +- this value."},
          {"encoder_resolution_rad", &o.encoder_resolution_rad, "rad", 0.0, 0.1,
           "Resolution of a joint encoder; 0 is exact."},
          {"encoder_rate_hz", &o.encoder_rate_hz, "Hz", 0.0, kFastest,
           "Encoder readings per second, rounded to whole time steps; 0 gives one reading per time step."},
          {"encoder_delay_s", &o.encoder_delay_s, "s", 0.0, kLongestDelay,
           "Delay of encoder readings, rounded to whole time steps."},
          {"speed_cutoff_hz", &o.speed_cutoff_hz, "Hz", 0.0, kFastest,
           "Bandwidth of the critically damped filter that estimates joint positions and speeds; 0 uses "
           "the difference of two readings."},
      });
}

OptionFields ImuFields(SensorOptions& o) {
  return WithBasics({"gyroscope_noise_rad_s_sqrt_hz", "accelerometer_noise_m_s2_sqrt_hz", "imu_delay_s"},
                    {
                        {"gyroscope_noise_rad_s_sqrt_hz", &o.gyroscope_noise_rad_s_sqrt_hz, "rad/s/sqrt(Hz)", 0.0, 1.0,
                         "White noise of the gyroscope, as a noise density."},
                        {"gyroscope_bias_rad_s", &o.gyroscope_bias_rad_s, "rad/s", 0.0, 1.0,
                         "Magnitude of the gyroscope's bias at the start."},
                        {"gyroscope_walk_rad_s2_sqrt_hz", &o.gyroscope_walk_rad_s2_sqrt_hz, "rad/s^2/sqrt(Hz)", 0.0,
                         1.0, "Random walk of the gyroscope's bias, as a noise density."},
                        {"gyroscope_cutoff_hz", &o.gyroscope_cutoff_hz, "Hz", 0.0, kFastest,
                         "Cut-off of the first-order low-pass filter on the controller's angular velocity; attitude "
                         "estimation uses unfiltered readings; 0 disables it."},
                        {"accelerometer_noise_m_s2_sqrt_hz", &o.accelerometer_noise_m_s2_sqrt_hz, "m/s^2/sqrt(Hz)", 0.0,
                         10.0, "White noise of the accelerometer, as a noise density."},
                        {"accelerometer_bias_m_s2", &o.accelerometer_bias_m_s2, "m/s^2", 0.0, 10.0,
                         "Magnitude of the accelerometer's bias at the start."},
                        {"accelerometer_walk_m_s3_sqrt_hz", &o.accelerometer_walk_m_s3_sqrt_hz, "m/s^3/sqrt(Hz)", 0.0,
                         10.0, "Random walk of the accelerometer's bias, as a noise density."},
                        {"imu_rate_hz", &o.imu_rate_hz, "Hz", 0.0, kFastest,
                         "IMU readings per second, rounded to whole time steps, each averaged since the last; 0 gives "
                         "one reading per time step."},
                        {"imu_delay_s", &o.imu_delay_s, "s", 0.0, kLongestDelay,
                         "Delay of IMU readings, rounded to whole time steps."},
                    });
}

OptionFields ContactFields(SensorOptions& o) {
  return WithBasics(
      {"contact_threshold", "contact_delay_s"},
      {
          {"contact_threshold", &o.contact_threshold, "1", 0.0, 1.0,
           "Normal force above which a foot sensor reports contact, as a share of the robot's weight."},
          {"contact_noise", &o.contact_noise, "1", 0.0, 1.0,
           "Standard deviation of the white noise of a foot's normal force, as a share of the robot's weight."},
          {"contact_rate_hz", &o.contact_rate_hz, "Hz", 0.0, kFastest,
           "Contact sensor readings per second, rounded to whole time steps; 0 gives one reading per time step."},
          {"contact_delay_s", &o.contact_delay_s, "s", 0.0, kLongestDelay,
           "Delay of contact readings, rounded to whole time steps."},
          {"contact_missed", &o.contact_missed, "1", 0.0, 1.0, "Share of readings in contact that report no contact."},
          {"contact_false", &o.contact_false, "1", 0.0, 1.0, "Share of readings in the air that report contact."},
      });
}

/// Index of a name in a list. @throws InvalidArgument listing the names.
std::size_t PlaceOf(const std::string& name, const std::vector<std::string>& names, const char* what) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end())
    throw InvalidArgument(fmt::format("unknown {} '{}'; accepted: {}", what, name, QuotedList(names)));
  return static_cast<std::size_t>(found - names.begin());
}

/// An IMU and encoders of research robots.
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

/// Sensors of low-cost robots.
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
                 {{"seed", &seed, "1", 0, 2147483647, "Random seed of all sensor noise and biases."}}});
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
