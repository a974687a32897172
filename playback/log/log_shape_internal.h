// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/base/data_shape.h"

namespace gaitwright {

inline constexpr char kLogFormat[] = "gaitwright-playback-log";

/// Ranges of values in a log that apply to the whole playback.
struct LogRange {
  double lowest, highest;
};
inline constexpr LogRange kLogStart{-1e6, 1e6};  // [s]
inline constexpr LogRange kLogRate{1e-3, 1e6};   // [Hz]
inline constexpr LogRange kLogStep{1e-9, 1.0};   // [s]
inline constexpr LogRange kLogMass{0.0, 1e6};    // [kg]
inline constexpr LogRange kLogFriction{0.0, 100.0};

// Shapes of the parts of a log file.
DataShape StanceShape();
DataShape BodyContactShape();
DataShape PenetrationShape();
DataShape LogGateShape();
DataShape LogPushShape();

}  // namespace gaitwright
