// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "playback/score/motion_series.h"

namespace gaitwright {

/// Smallest rise of the centre of mass on its way over an edge of the support [m]; negative when it is beyond an edge,
/// and minus the rise over the line itself when the support has no area. With R the distance of C from the edge, psi
/// the edge's inclination: rise = R cos(psi) - (height of C over the edge). Normalised energy stability margin: Messuri
/// and Klein, IEEE J. Robotics and Automation 1(3) 1985; Hirose et al., 2001. @pre a support.
double EnergyMargin(const MotionSample& sample);

}  // namespace gaitwright
