// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "workflows/exchange/even_motion.h"

namespace gaitwright {

/// Links that overlap in a motion.
struct PartedLinks {
  std::string links;                  ///< such as "'left_hand' and 'left_hip'"
  double depth_m = 0.0;               ///< of the deepest overlap
  double start_s = 0.0, end_s = 0.0;  ///< first and last time at which they overlap
};

/// Moves joints that belong to no leg, so that links that overlap in a motion come apart: arms out of hips. The
/// optimisation of the whole body then starts near a motion whose links do not touch, where distances have clear
/// directions. Each row begins with the correction of the row before it, which fades where nothing touches. Changes
/// positions alone. @param least_m  distance of links; at most half of that in the standing posture.
/// @return the links that overlapped before, the deepest overlap first.
std::vector<PartedLinks> PartLinks(const RobotModel& model, double least_m, EvenMotion& motion);

}  // namespace gaitwright
