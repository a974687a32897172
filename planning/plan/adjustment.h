// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "kinematics/base/failure_code.h"

namespace gaitwright {

/// A value of the plan that differs from the request or from the default, because that value gives no sound plan.
struct Adjustment {
  /// Flag or option that sets the value, without dashes: `speed`, `gait.cycle_s`.
  std::string what;
  double asked = 0.0, given = 0.0;
  std::string unit;                          ///< unit of both values; "1" for a number without unit
  FailureCode why = FailureCode::kInternal;  ///< why the requested value is refused, such as a failed check
  std::string part = {};                     ///< part of a sequence as "2: trot" (number from 1 and gait)

  bool operator==(const Adjustment&) const = default;
};

/// One line: "a cycle of 0.45 s instead of 0.5 s, which fails with 'joint_velocity'".
std::string AdjustmentText(const Adjustment& adjustment);

}  // namespace gaitwright
