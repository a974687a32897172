// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "kinematics/base/failure_code.h"

namespace gaitwright {

/// How much a finding about a robot description weighs.
enum class FindingLevel {
  kInfo,     ///< worth knowing; nothing is wrong
  kWarning,  ///< wrong or doubtful; the robot is loaded anyway
  kError,    ///< the robot is not loaded, cannot be simulated meaningfully, or cannot stand
};

/// Wrong or doubtful data in a robot description, and the replacement.
struct Finding {
  FindingLevel level = FindingLevel::kWarning;
  FailureCode code = FailureCode::kInternal;  ///< its kind; with `--strict`, why the file is refused
  std::string part;                           ///< where: "link 'trunk'", "joint 'FL_KFE'", "robot"
  int line = 0;                               ///< line in the file; 0 if it belongs to no single line
  std::string message;                        ///< finding and replacement

  bool operator==(const Finding&) const = default;
};

}  // namespace gaitwright
