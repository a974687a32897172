// SPDX-License-Identifier: BSD-3-Clause
#include "playback/sensing/imu.h"

#include <cmath>

#include "kinematics/model/robot_model.h"
#include "kinematics/spatial/rotation.h"

namespace gaitwright {
namespace {

constexpr int kGyroscopeStream = 2, kAccelerometerStream = 3;

}  // namespace

Imu::Imu(const SensorOptions& options, double step_s)
    : options_(options),
      step_s_(step_s),
      clock_(options.imu_rate_hz, step_s),
      gyroscope_noise_(options.seed, kGyroscopeStream),
      accelerometer_noise_(options.seed, kAccelerometerStream),
      gyroscope_bias_(options.gyroscope_bias_rad_s * gyroscope_noise_.Direction()),
      accelerometer_bias_(options.accelerometer_bias_m_s2 * accelerometer_noise_.Direction()),
      delay_(DelaySteps(options.imu_delay_s, step_s)) {}

const ImuReading& Imu::Read(const VectorX& q, const VectorX& v) {
  Gather(q, v);
  if (clock_.Tick()) Sample();
  return delay_.Push(now_);
}

void Imu::Gather(const VectorX& q, const VectorX& v) {
  const Matrix3 R_WB = BaseRotation(q);
  const Vector3 v_WB = v.head<3>(), gravity_W(0.0, 0.0, -kGravity);
  if (is_first_) {  // the first reading assumes constant motion during the step before
    is_first_ = false;
    v_WB_ = v_WB;
    R_WB_ = RotationExp(-step_s_ * v.segment<3>(3)) * R_WB;
  }
  sum_.rate_B += RotationLog(R_WB_.transpose() * R_WB) / step_s_;
  sum_.force_B += R_WB.transpose() * ((v_WB - v_WB_) / step_s_ - gravity_W);
  ++summed_;
  R_WB_ = R_WB;
  v_WB_ = v_WB;
}

void Imu::Sample() {
  const double T = clock_.interval_s(), per_reading = 1.0 / std::sqrt(T), walked = std::sqrt(T);
  gyroscope_bias_ += options_.gyroscope_walk_rad_s2_sqrt_hz * walked * gyroscope_noise_.Normal3();
  accelerometer_bias_ += options_.accelerometer_walk_m_s3_sqrt_hz * walked * accelerometer_noise_.Normal3();
  now_.rate_B = sum_.rate_B / summed_ + gyroscope_bias_ +
                options_.gyroscope_noise_rad_s_sqrt_hz * per_reading * gyroscope_noise_.Normal3();
  now_.force_B = sum_.force_B / summed_ + accelerometer_bias_ +
                 options_.accelerometer_noise_m_s2_sqrt_hz * per_reading * accelerometer_noise_.Normal3();
  sum_ = {};
  summed_ = 0;
}

}  // namespace gaitwright
