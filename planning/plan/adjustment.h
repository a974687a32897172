// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "kinematics/base/failure_code.h"

namespace gaitwright {

/// A quantity in which a plan differs from the request, or from the default, because that value gives no sound plan.
struct Adjustment {
  /// The flag or option that sets it, without dashes: `speed`, `gait.cycle_s`.
  std::string what;
  double asked = 0.0, given = 0.0;
  std::string unit;                          ///< of both; "1" for none
  FailureCode why = FailureCode::kInternal;  ///< why the plan with the requested value is refused, such as a law
  std::string part = {};                     ///< of a sequence: its number from 1 on and gait, as "2: trot"

  bool operator==(const Adjustment&) const = default;
};

/// One line: "a cycle of 0.45 s instead of 0.5 s, which fails for 'joint_velocity'".
std::string AdjustmentText(const Adjustment& adjustment);

}  // namespace gaitwright
