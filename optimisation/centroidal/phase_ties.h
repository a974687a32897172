// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/spatial/pose.h"

namespace gaitwright {

/// Dependence of the durations of a problem's phases (SwitchTimes) on fewer parts, as all cycles of a periodic gait
/// depend on the durations within one cycle:
///   durations = phases_by_parts * parts + rest_s.
/// The sum of the parts is constant.
struct PhaseTies {
  MatrixX phases_by_parts;  ///< a row for each phase, a column for each part; for a fixed total duration, each
                            ///< column adds up to 0
  VectorX rest_s;           ///< by phase
  VectorX parts_s;          ///< the parts at the given times
  VectorX shortest_s;       ///< by part; at most its given duration
};

}  // namespace gaitwright
