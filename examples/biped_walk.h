// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "playback/score/stability_report.h"

namespace gaitwright::examples {

/// What came of a biped's walk. Margins are those of the zero-moment point (ZMP) as measured, from the edge of the
/// support, positive inside: the least of the whole walk [m].
struct BipedWalk {
  StabilityReport report;
  double margin_one_foot_m = 0.0;   ///< while one sole is the support
  double margin_both_feet_m = 0.0;  ///< while it is the hull of both
};

/// Why a biped with soles does not tip over: the point where the ground's forces act stays inside what it stands on.
/// Walks a number of footfalls, the last one closing the feet, and measures how far inside.
/// @throws InvalidArgument with the reason, for a robot that has not two legs or steps that it cannot make.
BipedWalk WalkBiped(const std::string& robot, int steps, double step_length_m);

}  // namespace gaitwright::examples
