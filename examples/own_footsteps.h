// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "workflows/exchange/placed_steps.h"

namespace gaitwright::examples {

/// A footstep planner of one's own: the body goes round an arc that begins at the origin along x, and each foot in turn
/// is put where it stands under the body, a round of all feet further on. The feet of one side step from the rear to
/// the front, then those of the other: the order in which a quadruped that crawls stands most safely (McGhee and Frank,
/// Mathematical Biosciences 3, 1968, doi:10.1016/0025-5564(68)90090-4).
/// @param turn_rad  left positive.   @param stride_m  the farthest that the body goes in a round.
/// @throws InvalidArgument unless radius and stride are more than 0 and turn_rad is other than 0, all finite.
std::vector<PlacedStep> StepsOnArc(const RobotModel& model, double radius_m, double turn_rad, double stride_m);

}  // namespace gaitwright::examples
