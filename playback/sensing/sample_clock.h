// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

namespace gaitwright {

/// When a sensor is read: every so many time steps, the first step among them.
class SampleClock {
 public:
  SampleClock() = default;
  /// The nearest whole number of steps to `rate_hz`; every step where that is 0 or faster than the steps.
  SampleClock(double rate_hz, double step_s)
      : stride_(rate_hz > 0.0 ? std::max(1L, std::lround(std::min(1.0 / (rate_hz * step_s), kMostSteps))) : 1L),
        interval_s_(static_cast<double>(stride_) * step_s) {}

  /// Counts a step. @return whether it is one at which to read.
  bool Tick() {
    const bool reads = count_ == 0;
    count_ = (count_ + 1) % stride_;
    return reads;
  }

  double interval_s() const { return interval_s_; }  ///< from one reading to the next

 private:
  static constexpr double kMostSteps = 1e15;  // beyond them there is but the first reading

  long stride_ = 1, count_ = 0;
  double interval_s_ = 0.001;
};

}  // namespace gaitwright
