// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/model/motor.h"

namespace gaitwright::engine {

/// What a motor may give.
struct EffortRange {
  double lowest, highest;  ///< [N m]; not above and not below 0

  double largest() const { return highest > -lowest ? highest : -lowest; }
};

/// One motor with its power stage, from step to step: its peak effort, less what its torque-speed curve leaves of it
/// along the motion, less what its warmth leaves of it, whichever is less.
class Drive {
 public:
  /// @param peak  largest effort, infinite for none.  @param motor  without what shall not act.
  Drive(const Motor& motor, double peak);

  /// The range in a step that begins at a speed.
  EffortRange At(double speed) const;

  /// A step has passed under an effort.
  void Warm(double effort, double step_s);

  /// Of effort over thermal_s (see EffortWhenWarm), cold at first; 0 without a continuous effort [N^2 m^2].
  double mean_square() const { return mean_square_; }

 private:
  Motor motor_;
  double peak_;
  bool warms_;
  double mean_square_ = 0.0;
};

}  // namespace gaitwright::engine
