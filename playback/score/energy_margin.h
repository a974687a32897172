// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "playback/score/motion_series.h"

namespace gaitwright {

/// Smallest rise of the centre of mass needed to tip over an edge of the support [m]. Negative if it is beyond an edge.
/// For a support without area, minus the rise over the line. With R the distance of C from the edge and psi the edge's
/// inclination: rise = R cos(psi) - (height of C above the edge). Normalised energy stability margin: Messuri and
/// Klein, IEEE J. Robotics and Automation 1(3) 1985; Hirose et al., 2001. @pre a support.
double EnergyMargin(const MotionSample& sample);

}  // namespace gaitwright
