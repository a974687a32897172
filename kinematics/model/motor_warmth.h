// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/model/motor.h"

namespace gaitwright {

/// A drive reduces the effort if the mean square of effort exceeds this share of the square of the continuous effort.
inline constexpr double kWarm = 0.8;

/// Largest effort that a drive with I^2 t protection allows, in either direction. Let c be the continuous effort and w
/// the mean square of effort over `thermal_s`, dw/dt = (effort^2 - w) / thermal_s. The limit is the peak up to w = 0.8
/// c^2, and falls linearly from there to c at w = c^2. Under permanent demand, w tends to c^2 and the effort to c.
/// @param mean_square  w [N^2 m^2].  @param peak  largest effort of a cold motor [N m]; infinite if unknown.
double EffortWhenWarm(const Motor& motor, double mean_square, double peak);

/// w after a time under a constant effort, exact: w' = effort^2 + (w - effort^2) e^(-time / thermal_s).
double WarmthAfter(const Motor& motor, double mean_square, double effort, double time_s);

}  // namespace gaitwright
