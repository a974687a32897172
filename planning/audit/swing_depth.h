// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "planning/audit/tolerances.h"

namespace gaitwright {

/// How much of what holds for a foot that stands holds for it at a fraction u of its swing: 1 at both ends, less and
/// less over the first and the last tenth of it, then 0.
inline double SwingEndShare(double u) {
  constexpr double kEnds = 0.1;
  return std::clamp(1.0 - std::min(u, 1.0 - u) / kEnds, 0.0, 1.0);
}

/// How deep a foot may be in the ground at a fraction of its swing [m]: as in stance where it leaves it and comes back,
/// since a ball rests on its foothold's plane and not on what is curved or tilted beside it; then no more than
/// rounding.
inline double SwingDepth(double u) {
  return tolerance::kTouching + (tolerance::kPosition - tolerance::kTouching) * SwingEndShare(u);
}

}  // namespace gaitwright
