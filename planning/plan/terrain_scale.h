// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// Lengths of a robot [m] from which the sizes of grounds follow. The robot stands with its base over the origin of W
/// and faces x.
struct TerrainScale {
  double leg_length_m = 0.4;
  double body_length_m = 0.6, body_width_m = 0.4, body_height_m = 0.45;  ///< extent of its feet and collision shapes
  double front_m = 0.3;                                                  ///< extent in front of the origin
  double stance_width_m = 0.3;                                           ///< between the outer edges of its feet
  double foot_length_m = 0.04, foot_width_m = 0.04;                      ///< of the longest and the widest foot
};

/// The scale of a robot in its standing posture.
TerrainScale ScaleOf(const RobotModel& model);

}  // namespace gaitwright
