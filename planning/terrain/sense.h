// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace gaitwright {

// Plausible limits for ground of legged robots. Numbers beyond them are probably mistakes or not in metres.

inline constexpr double kFarthest = 1000.0;    ///< distance of a place in plan view [m]
inline constexpr double kHighest = 50.0;       ///< absolute height [m]
inline constexpr double kSteepestStep = 20.0;  ///< height difference between neighbouring points of a height map [m]
inline constexpr double kLeastFriction = 0.01, kMostFriction = 5.0;  ///< coefficients
inline constexpr int kMostNodes = 4000000;                           ///< points of a height field

}  // namespace gaitwright
