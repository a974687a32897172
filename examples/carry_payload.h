// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "playback/score/stability_report.h"

namespace gaitwright::examples {

/// Result of standing with a payload.
struct CarriedPayload {
  std::vector<double> estimates_kg;  ///< one per ms, from the release of the robot
  StabilityReport report;
};

/// A built-in robot stands for 3 s under AdaptivePd, with a payload in its base that plan and controller do not know.
/// @throws InvalidArgument if the payload is below 0, or if the robot cannot stand.
CarriedPayload CarryPayload(const std::string& robot, double payload_kg, double rate_per_s);

}  // namespace gaitwright::examples
