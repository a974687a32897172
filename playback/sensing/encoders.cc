// SPDX-License-Identifier: BSD-3-Clause
#include "playback/sensing/encoders.h"

#include <cmath>
#include <numbers>

namespace gaitwright {
namespace {

constexpr int kEncoderStream = 1;

}  // namespace

Encoders::Encoders(Eigen::Index joints, const SensorOptions& options, double step_s)
    : options_(options),
      clock_(options.encoder_rate_hz, step_s),
      noise_(options.seed, kEncoderStream),
      bias_(joints),
      delay_(DelaySteps(options.encoder_delay_s, step_s)) {
  for (double& bias : bias_) bias = options.encoder_bias_rad * (2.0 * noise_.Uniform() - 1.0);
  if (options.speed_cutoff_hz > 0.0)
    keep_ = std::exp(-2.0 * std::numbers::pi * options.speed_cutoff_hz * clock_.interval_s());
  now_.q_raw = now_.q = now_.v = VectorX::Zero(joints);
}

const JointReading& Encoders::Read(const Eigen::Ref<const VectorX>& q) {
  now_.is_fresh = clock_.Tick();
  if (now_.is_fresh) Sample(q);
  return delay_.Push(now_);
}

void Encoders::Sample(const Eigen::Ref<const VectorX>& q) {
  for (Eigen::Index i = 0; i < q.size(); ++i) {
    double reading = q[i] + bias_[i] + options_.encoder_noise_rad * noise_.Normal();
    const double resolution = options_.encoder_resolution_rad;
    if (resolution > 0.0) reading = resolution * std::round(reading / resolution);
    now_.q_raw[i] = reading;
  }
  Track();
}

void Encoders::Track() {
  if (is_first_) {
    is_first_ = false;
    now_.q = now_.q_raw;
    return;
  }
  const double T = clock_.interval_s();
  for (Eigen::Index i = 0; i < now_.q.size(); ++i) {
    const double expected = now_.q[i] + T * now_.v[i], miss = now_.q_raw[i] - expected;
    now_.q[i] = expected + (1.0 - keep_ * keep_) * miss;
    now_.v[i] += (1.0 - keep_) * (1.0 - keep_) * miss / T;
  }
}

}  // namespace gaitwright
