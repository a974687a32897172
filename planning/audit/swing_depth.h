// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "planning/audit/tolerances.h"

namespace gaitwright {

/// Weight of the stance rules at a fraction u of a swing: 1 at both ends, 0 except in the first and the last tenth.
inline double SwingEndShare(double u) {
  constexpr double kEnds = 0.1;
  return std::clamp(1.0 - std::min(u, 1.0 - u) / kEnds, 0.0, 1.0);
}

/// Allowed depth of a foot in the ground at a fraction of its swing [m]. At both ends it is as in stance, because a
/// sphere touches its foothold's plane and not the curved or tilted ground beside it; otherwise it covers only
/// rounding.
inline double SwingDepth(double u) {
  return tolerance::kTouching + (tolerance::kPosition - tolerance::kTouching) * SwingEndShare(u);
}

}  // namespace gaitwright
