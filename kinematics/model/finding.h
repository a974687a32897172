// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "kinematics/base/failure_code.h"
#include "kinematics/base/result.h"

namespace gaitwright {

/// Severity of a finding about a robot description.
enum class FindingLevel {
  kInfo,     ///< worth knowing; nothing is wrong
  kWarning,  ///< wrong or doubtful; the robot is loaded anyway
  kError,    ///< the robot is not loaded, cannot be simulated meaningfully, or cannot stand
};

/// Wrong or doubtful data in a robot description, and the replacement.
struct Finding {
  FindingLevel level = FindingLevel::kWarning;
  FailureCode code = FailureCode::kInternal;  ///< kind of the finding; failure code of the refusal with `--strict`
  RobotPart part = {};
  int line = 0;         ///< line in the file; 0 if there is no single line
  std::string message;  ///< finding and replacement

  bool operator==(const Finding&) const = default;
};

}  // namespace gaitwright
