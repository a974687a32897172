// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

namespace gaitwright {

/// A delay, rounded to whole time steps.
inline std::size_t DelaySteps(double delay_s, double step_s) {
  return static_cast<std::size_t>(std::lround(delay_s / step_s));
}

/// Returns each value a fixed number of steps after its input; until then, the first value. Allocates nothing after it
/// is full, if copies of values of equal size allocate nothing.
template <class Value>
class DelayLine {
 public:
  explicit DelayLine(std::size_t steps = 0) : ring_(steps + 1) {}

  /// Adds a value and returns the delayed one.
  const Value& Push(const Value& value) {
    if (is_empty_) {
      for (Value& place : ring_) place = value;
      is_empty_ = false;
    }
    ring_[next_] = value;
    next_ = (next_ + 1) % ring_.size();
    return ring_[next_];
  }

  /// Clears the line; the next value fills it.
  void Reset() { is_empty_ = true; }

 private:
  std::vector<Value> ring_;
  std::size_t next_ = 0;
  bool is_empty_ = true;
};

}  // namespace gaitwright
