// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "kinematics/model/motor_warmth.h"
#include "playback/engine/drive_internal.h"

namespace gaitwright::engine {

Drive::Drive(const Motor& motor, double peak) : motor_(motor), peak_(peak), warms_(motor.continuous_effort < peak) {}

EffortRange Drive::At(double speed) const {
  EffortRange range{-motor_.EffortAt(-speed, peak_), motor_.EffortAt(speed, peak_)};
  if (!warms_) return range;
  const double lets_through = EffortWhenWarm(motor_, mean_square_, peak_);
  return {std::max(range.lowest, -lets_through), std::min(range.highest, lets_through)};
}

void Drive::Warm(double effort, double step_s) {
  if (warms_) mean_square_ = WarmthAfter(motor_, mean_square_, effort, step_s);
}

}  // namespace gaitwright::engine
