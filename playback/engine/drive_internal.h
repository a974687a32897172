// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/model/motor.h"

namespace gaitwright::engine {

/// Range of effort that a motor can give.
struct EffortRange {
  double lowest, highest;  ///< [N m]; lowest <= 0 <= highest

  double largest() const { return highest > -lowest ? highest : -lowest; }
};

/// One motor with its power stage, over many steps. Its effort is limited to the smaller of its torque-speed curve
/// along the motion and its thermal limit, both at most its peak effort.
class Drive {
 public:
  /// @param peak  largest effort, infinite if unlimited.  @param motor  without the limits that are switched off.
  Drive(const Motor& motor, double peak);

  /// Range of effort in a step that begins at a speed.
  EffortRange At(double speed) const;

  /// Advances the motor's warmth by a step under an effort.
  void Warm(double effort, double step_s);

  /// Mean square of effort over thermal_s (see EffortWhenWarm), initially 0; 0 without a continuous effort [N^2 m^2].
  double mean_square() const { return mean_square_; }

 private:
  Motor motor_;
  double peak_;
  bool warms_;
  double mean_square_ = 0.0;
};

}  // namespace gaitwright::engine
