// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "playback/score/stability_report.h"

namespace gaitwright::examples {

/// Result of a leap. The measured values are from the first to the last sample of the log without a foot on the ground;
/// samples are 5 ms apart.
struct Leap {
  StabilityReport report;
  double planned_air_s = 0.0;  ///< from the contact schedule
  double air_s = 0.0;          ///< measured
  double rise_m = 0.0;         ///< rise of the centre of mass from lift-off to its highest point
  double drop_m = 0.0;         ///< drop of the centre of mass from there to touch-down
};

/// Plays one leap forward, from all feet onto all feet. In flight only the weight acts on a robot, so its centre of
/// mass moves on a parabola, whatever the legs do:
///   air = sqrt(2 rise / g) + sqrt(2 drop / g).
/// @throws InvalidArgument if the robot does not have the gait `jump`, or if it cannot make this leap.
Leap LeapForward(const std::string& robot, double length_m);

}  // namespace gaitwright::examples
