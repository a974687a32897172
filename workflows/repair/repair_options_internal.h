// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/base/options.h"

namespace gaitwright {

/// Options of the repair of a motion. Lengths and speeds scale with the leg length l: a share of l, and of sqrt(g l).
///
/// Tuning
///   a foot that stands is taken for one that swings      raise stand_height, stand_speed
///   a foot that swings low is taken for one that stands  lower stand_speed
///   arms or legs keep too little of the motion           raise joint
///   the base keeps too little of the motion              raise base_position, base_rotation
///   motors are near their limits                         raise effort
struct RepairOptions {
  double smoothing_hz = 0.0;
  double stand_height = 0.02, stand_speed = 0.1, stand_tilt_rad = 0.25;
  double leave = 1.8;
  double least_stance_s = 0.1, least_swing_s = 0.1;
  double clearance = 0.015, sole_margin = 0.025, effort_use = 0.65;
  double base_position = 8.0, base_rotation = 6.0, joint = 2.0, acceleration = 1.0, effort = 0.1;
  double rest_s = 0.6;
  double window_s = 12.0, overlap_s = 1.5;
  double stretch = 1.0, stretch_over_rad = 0.15;
  double leave_out = 0.5;

  OptionFields Fields();
};

}  // namespace gaitwright
