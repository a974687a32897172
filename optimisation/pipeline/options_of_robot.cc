// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "kinematics/stability/standing_width_internal.h"
#include "optimisation/pipeline/options_of_robot_internal.h"

namespace gaitwright {

MotionOptions OptionsOf(const RobotModel& model, MotionOptions options) {
  constexpr double kMoment = 0.1;  // [s] in which a robot on two points hardly begins to fall
  if (CanStandStill(model)) return options;
  options.centre_of_mass.method = "rigid-body";
  options.footsteps.initial_stand_s = std::min(options.footsteps.initial_stand_s, kMoment);
  options.footsteps.final_stand_s = std::min(options.footsteps.final_stand_s, kMoment);
  return options;
}

}  // namespace gaitwright
