// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "workflows/exchange/placed_steps.h"

namespace gaitwright::examples {

/// Example of a user's own footstep planner. The body follows an arc that begins at the origin along x. In each round
/// of all feet, each foot is placed at its nominal position below the body pose at the end of the round. The feet of
/// one side step from rear to front, then the feet of the other side: this order gives a crawling quadruped the largest
/// stability margin (McGhee and Frank, Mathematical Biosciences 3, 1968, doi:10.1016/0025-5564(68)90090-4).
/// @param turn_rad  left positive.   @param stride_m  maximum advance of the body in a round.
/// @throws InvalidArgument unless radius and stride are more than 0, turn_rad is not 0, and all are finite.
std::vector<PlacedStep> StepsOnArc(const RobotModel& model, double radius_m, double turn_rad, double stride_m);

}  // namespace gaitwright::examples
