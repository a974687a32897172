// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ostream>
#include <string>

#include "workflows/walk/walk.h"

namespace gaitwright {

/// A walk over a named ground, at the robot's default speed.
struct UnevenWalk {
  std::string robot, terrain;
  double distance_m = 0.0;                ///< straight forward, or
  double goal_x_m = 0.0, goal_y_m = 0.0;  ///< a goal, if no distance is given
  std::string gait = {};
};

void PrintTo(const UnevenWalk& walk, std::ostream* out);

/// Plans the walk and plays it with the default controller. Expects all gates passed, no scuffs, a penetration of at
/// most 1 mm, and a clearance within 5 mm of the planned one (2 mm for legs shorter than 0.3 m).
void ExpectToWalk(const UnevenWalk& walk);

}  // namespace gaitwright
