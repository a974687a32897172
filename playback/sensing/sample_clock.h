// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

namespace gaitwright {

/// Schedule of a sensor: a reading every N time steps, starting with the first step.
class SampleClock {
 public:
  SampleClock() = default;
  /// Rounds to whole steps per reading; every step if `rate_hz` is 0 or faster than the steps.
  SampleClock(double rate_hz, double step_s)
      : stride_(rate_hz > 0.0 ? std::max(1L, std::lround(std::min(1.0 / (rate_hz * step_s), kMostSteps))) : 1L),
        interval_s_(static_cast<double>(stride_) * step_s) {}

  /// Counts a step. @return whether the sensor is read in it.
  bool Tick() {
    const bool reads = count_ == 0;
    count_ = (count_ + 1) % stride_;
    return reads;
  }

  double interval_s() const { return interval_s_; }  ///< between readings

 private:
  static constexpr double kMostSteps = 1e15;  // for longer intervals there is only the first reading

  long stride_ = 1, count_ = 0;
  double interval_s_ = 0.001;
};

}  // namespace gaitwright
