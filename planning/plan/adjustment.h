// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "kinematics/base/failure_code.h"

namespace gaitwright {

/// A quantity that a plan has otherwise than was asked for, or than is usual, since no sound plan has it so.
struct Adjustment {
  /// The flag or option that would ask for it, without dashes: `speed`, `gait.cycle_s`.
  std::string what;
  double asked = 0.0, given = 0.0;
  std::string unit;                          ///< of both; "1" for none
  FailureCode why = FailureCode::kInternal;  ///< what the plan as asked for is refused for, such as a law
  std::string part = {};                     ///< of a sequence: its number from 1 on and gait, as "2: trot"

  bool operator==(const Adjustment&) const = default;
};

/// One line for people: "a cycle of 0.45 s instead of 0.5 s, which fails for 'joint_velocity'".
std::string AdjustmentText(const Adjustment& adjustment);

}  // namespace gaitwright
