// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ostream>
#include <string>

#include "workflows/walk/walk.h"

namespace gaitwright {

/// A walk over ground by name, at the robot's own speed.
struct UnevenWalk {
  std::string robot, terrain;
  double distance_m = 0.0;                ///< straight ahead; or
  double goal_x_m = 0.0, goal_y_m = 0.0;  ///< a goal, where it is not given
  std::string gait = {};
};

void PrintTo(const UnevenWalk& walk, std::ostream* out);

/// Plans the walk, plays it with the controller that there is by default, and expects it to pass every gate, without a
/// scuff, in the ground by a millimetre at most, and its feet over it as high as planned to 5 mm, or 2 mm for robots
/// whose legs are shorter than 0.3 m.
void ExpectToWalk(const UnevenWalk& walk);

}  // namespace gaitwright
