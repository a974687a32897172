// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace gaitwright {

// What makes sense for ground that legs walk on; numbers beyond are in other units than metres, or not meant so.

inline constexpr double kFarthest = 1000.0;                          ///< of a place in plan view [m]
inline constexpr double kHighest = 50.0;                             ///< of a height, up or down [m]
inline constexpr double kSteepestStep = 20.0;                        ///< from a point of a height map to the next [m]
inline constexpr double kLeastFriction = 0.01, kMostFriction = 5.0;  ///< coefficients
inline constexpr int kMostNodes = 4000000;                           ///< of a height field

}  // namespace gaitwright
