// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "playback/score/stability_report.h"

namespace gaitwright::examples {

/// How often feet came down on one surface of the ground; those that stand there at the start do not count.
struct PatchTread {
  std::string patch;  ///< its name, such as "step 1"
  int planned = 0, measured = 0;
  double height_m = 0.0;  ///< of its highest point that was touched, as measured
};

/// What came of a climb.
struct Climb {
  std::vector<PatchTread> treads;  ///< of each surface, in the ground's order
  StabilityReport report;
};

/// The ground is one value for planner, physics and you: walks straight ahead over it, and asks it which of its patches
/// each foot was to stand on, and which it did come down on.
/// @param terrain  a ground by its name with parameters, see docs/terrain-format.md: "stairs:rise_m=0.07,count=3".
/// @throws InvalidArgument with the reason, for a ground that there is not or that the robot cannot climb.
Climb ClimbStairs(const std::string& robot, const std::string& terrain, double distance_m);

}  // namespace gaitwright::examples
