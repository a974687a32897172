// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "playback/sensing/delay_line.h"
#include "playback/sensing/noise_stream.h"
#include "playback/sensing/sample_clock.h"
#include "playback/sensing/sensor_options.h"

namespace gaitwright {

/// Readings of the encoders of the independent joints, raw and filtered.
struct JointReading {
  VectorX q_raw;         ///< as read [rad] or [m]
  VectorX q, v;          ///< filtered, and speeds [rad/s]
  bool is_fresh = true;  ///< read in this step, not held from an earlier one
};

/// Encoders of all independent joints with bias, noise, resolution, rate and delay; speeds by a critically damped
/// tracking filter with poles at w = 2 pi speed_cutoff_hz, T from one reading to the next, rho = exp(-w T):
///   r = y - (q + T v),   q += T v + (1 - rho^2) r,   v += (1 - rho)^2 r / T
/// which follows steady motion without lag; its speed lags by 2 / w, and noise of standard deviation s gives it about
/// s sqrt(T w^3) / 2. Without a cut-off rho is 0: the difference of two readings. Benedict and Bordner, IRE
/// Transactions on Automatic Control 7(4), 1962, doi:10.1109/TAC.1962.1105477.
class Encoders {
 public:
  Encoders(Eigen::Index joints, const SensorOptions& options, double step_s);

  /// Call once per step. @param q  true positions of the independent joints.
  const JointReading& Read(const Eigen::Ref<const VectorX>& q);

  /// Zero offset of each joint: constant error of the readings, in addition to noise.
  const VectorX& bias() const { return bias_; }

 private:
  void Sample(const Eigen::Ref<const VectorX>& q);
  void Track();

  const SensorOptions options_;
  SampleClock clock_;
  NoiseStream noise_;
  VectorX bias_;
  double keep_ = 0.0;  // rho
  bool is_first_ = true;
  JointReading now_;
  DelayLine<JointReading> delay_;
};

}  // namespace gaitwright
