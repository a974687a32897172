// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "playback/score/stability_report.h"

namespace gaitwright::examples {

/// What came of a leap. Measured figures are from the first to the last sample of the log without any foot on the
/// ground, 5 ms from one to the next.
struct Leap {
  StabilityReport report;
  double planned_air_s = 0.0;  ///< by the contact schedule
  double air_s = 0.0;          ///< as measured
  double rise_m = 0.0;         ///< of the centre of mass, from leaving the ground to the highest point
  double drop_m = 0.0;         ///< from there to coming down
};

/// In the air nothing but its weight acts on a robot, so its centre of mass is thrown like a stone, whatever the legs
/// do:
///   air = sqrt(2 rise / g) + sqrt(2 drop / g).
/// Makes one leap ahead, from all feet onto all feet.
/// @throws InvalidArgument with the reason, for a robot without the gait `jump` or a leap that it cannot make.
Leap LeapAhead(const std::string& robot, double length_m);

}  // namespace gaitwright::examples
