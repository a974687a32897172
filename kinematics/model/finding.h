// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "kinematics/base/failure_code.h"

namespace gaitwright {

/// How much a finding about a robot description weighs.
enum class FindingLevel {
  kInfo,     ///< worth knowing; nothing is wrong
  kWarning,  ///< wrong or doubtful; the robot is loaded all the same
  kError,    ///< the robot is not loaded, what is computed of it means nothing, or it cannot stand as it is
};

/// Something that is wrong or doubtful in a robot description, and what is used in its place.
struct Finding {
  FindingLevel level = FindingLevel::kWarning;
  FailureCode code = FailureCode::kInternal;  ///< its kind; with `--strict`, why the file is refused
  std::string part;                           ///< where: "link 'trunk'", "joint 'FL_KFE'", "robot"
  int line = 0;                               ///< of the file; 0 where it is of no single line
  std::string message;                        ///< what was found, and what is used

  bool operator==(const Finding&) const = default;
};

}  // namespace gaitwright
