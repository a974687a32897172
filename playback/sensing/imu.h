// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "playback/sensing/delay_line.h"
#include "playback/sensing/noise_stream.h"
#include "playback/sensing/sample_clock.h"
#include "playback/sensing/sensor_options.h"

namespace gaitwright {

/// Reading of an inertial measurement unit at the base's origin, in base axes.
struct ImuReading {
  Vector3 rate_B = Vector3::Zero();   ///< angular velocity [rad/s]
  Vector3 force_B = Vector3::Zero();  ///< specific force R_WB^T (a_WB - g) [m/s^2]
};

/// Gyroscope and accelerometer with noise, bias, its random walk, rate and delay. A reading is the mean since the last
/// one, as in units that integrate internally: with the time step h,
///   rate = log(R(t-h)^T R(t)) / h,   force = R(t)^T ((v(t) - v(t-h)) / h - g).
/// Woodman, An introduction to inertial navigation, Cambridge UCAM-CL-TR-696, 2007.
class Imu {
 public:
  Imu(const SensorOptions& options, double step_s);

  /// Call once per step. @param q, v  true state, in the orders of RobotModel.
  const ImuReading& Read(const VectorX& q, const VectorX& v);

  // Biases of the last reading before the delay.
  const Vector3& gyroscope_bias() const { return gyroscope_bias_; }          ///< [rad/s]
  const Vector3& accelerometer_bias() const { return accelerometer_bias_; }  ///< [m/s^2]

 private:
  void Gather(const VectorX& q, const VectorX& v);
  void Sample();

  const SensorOptions options_;
  const double step_s_;
  SampleClock clock_;
  NoiseStream gyroscope_noise_, accelerometer_noise_;
  Vector3 gyroscope_bias_, accelerometer_bias_;
  bool is_first_ = true;
  Matrix3 R_WB_ = Matrix3::Identity();  // of the previous step
  Vector3 v_WB_ = Vector3::Zero();
  ImuReading sum_, now_;
  int summed_ = 0;
  DelayLine<ImuReading> delay_;
};

}  // namespace gaitwright
