// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/spatial/pose.h"

namespace gaitwright {

/// How the durations of a problem's phases (SwitchTimes) follow from fewer ones, as all cycles of a periodic gait
/// follow from the durations within one:
///   durations = phases_by_parts * parts + rest_s.
/// The parts add up to what they do where they are given.
struct PhaseTies {
  MatrixX phases_by_parts;  ///< a row for each phase, a column for each part; columns of them add up to 0 where the
                            ///< duration of the whole is to stay
  VectorX rest_s;           ///< by phase
  VectorX parts_s;          ///< the parts at the times that are given
  VectorX shortest_s;       ///< of each part, no more than it is given
};

}  // namespace gaitwright
