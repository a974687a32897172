// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "playback/score/stability_report.h"

namespace gaitwright::examples {

/// Result of a biped's walk. A margin is the smallest distance of the measured zero-moment point (ZMP) from the edge of
/// the support polygon during the walk [m], positive inside.
struct BipedWalk {
  StabilityReport report;
  double margin_one_foot_m = 0.0;   ///< while one foot is in stance
  double margin_both_feet_m = 0.0;  ///< while both feet are in stance; the support polygon is the hull of both soles
};

/// Shows why a biped with soles does not tip over: its ZMP stays inside the support polygon.
/// Plays a walk of `steps` footfalls, of which the last one closes the feet, and measures the margins of the ZMP.
/// @throws InvalidArgument if the robot does not have two legs, or if it cannot make these steps.
BipedWalk WalkBiped(const std::string& robot, int steps, double step_length_m);

}  // namespace gaitwright::examples
