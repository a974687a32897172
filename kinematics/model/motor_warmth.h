// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/model/motor.h"

namespace gaitwright {

/// Share of the square of the continuous effort that the mean square of effort may reach before a drive takes effort
/// back.
inline constexpr double kWarm = 0.8;

/// Largest effort that a drive with I^2 t protection lets through, in either direction: with c the continuous effort
/// and w the mean square of effort over `thermal_s`, dw/dt = (effort^2 - w) / thermal_s, it is the peak up to w = 0.8
/// c^2, and falls from there in a line to c at w = c^2. Under lasting demand w ends at c^2, and effort at c.
/// @param mean_square  w [N^2 m^2].  @param peak  largest effort when cold [N m]; infinite where there is none.
double EffortWhenWarm(const Motor& motor, double mean_square, double peak);

/// w after a time under a constant effort, exactly: w' = effort^2 + (w - effort^2) e^(-time / thermal_s).
double WarmthAfter(const Motor& motor, double mean_square, double effort, double time_s);

}  // namespace gaitwright
