// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "workflows/exchange/even_motion.h"

namespace gaitwright {

/// Moves joints that belong to no leg, so that links that overlap in a motion come apart: arms out of hips. The
/// optimisation of the whole body then starts near a motion whose links do not touch, where distances have clear
/// directions. Each row begins with the correction of the row before it, which fades where nothing touches. Changes
/// positions alone. @param least_m  distance of links; at most half of that in the standing posture.
/// @return the deepest overlap before [m], 0 if no links overlap.
double PartLinks(const RobotModel& model, double least_m, EvenMotion& motion);

}  // namespace gaitwright
