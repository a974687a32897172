// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// Bends the end of one motion so that it comes to where another one begins: to its state and rates at a row. Each
/// component gets the quintic c of time that is 0 with its first two derivatives where the bend begins, and at the row
/// the difference of the two motions, with c'' = 0; base rotations get it as a rotation vector, the zero-moment point
/// c - c'' / omega^2 of the centre of mass. Torques and forces stay, so that differences have to be small.
/// @param row, then_row  of the same time; the bend takes up to kBend seconds before.
void CloseSeam(MotionPlan& plan, std::size_t row, const MotionPlan& then, std::size_t then_row);

inline constexpr double kBend = 0.4;  ///< [s]

}  // namespace gaitwright
