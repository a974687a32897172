// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// Blends the end of one motion to the state and rates of another motion at a row. To each component the quintic c(t)
/// is added: it is 0 with its first two derivatives where the blend begins; at the row it equals the difference of the
/// two motions, with c'' = 0. For the base rotation, c is a rotation vector. The zero-moment point gets c - c'' /
/// omega^2 of the centre of mass. Torques and forces are not changed, so differences must be small.
/// @param row, then_row  rows of the same time; the blend takes at most kBend seconds before it.
void CloseSeam(MotionPlan& plan, std::size_t row, const MotionPlan& then, std::size_t then_row);

inline constexpr double kBend = 0.4;  ///< [s]

}  // namespace gaitwright
