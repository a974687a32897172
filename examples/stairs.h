// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "playback/score/stability_report.h"

namespace gaitwright::examples {

/// Number of touch-downs on one surface of the ground. Feet that stand on it at the start do not count.
struct PatchTread {
  std::string patch;  ///< name of the surface, such as "step 1"
  int planned = 0, measured = 0;
  double height_m = 0.0;  ///< of the highest measured touch-down on the surface
};

/// Result of a climb.
struct Climb {
  std::vector<PatchTread> treads;  ///< one for each surface, in the order of the terrain
  StabilityReport report;
};

/// Plays a straight walk over a terrain, and counts the planned and the measured touch-downs on each of its surfaces.
/// The planner, the physics engine and this example use the same `Terrain` value.
/// @param terrain  name of a terrain with parameters, such as "stairs:rise_m=0.07,count=3"; see docs/terrain-format.md.
/// @throws InvalidArgument if the terrain does not exist, or if the robot cannot climb it.
Climb ClimbStairs(const std::string& robot, const std::string& terrain, double distance_m);

}  // namespace gaitwright::examples
