// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "playback/score/stability_report.h"

namespace gaitwright::examples {

/// What came of standing with a payload.
struct CarriedPayload {
  std::vector<double> estimates_kg;  ///< every ms, from when the robot was let go
  StabilityReport report;
};

/// A robot that comes with the program stands for 3 s by AdaptivePd, with a payload in its base that neither plan nor
/// controller is told of. @throws InvalidArgument for a payload below 0, with the reason where it cannot be done.
CarriedPayload CarryPayload(const std::string& robot, double payload_kg, double rate_per_s);

}  // namespace gaitwright::examples
