// SPDX-License-Identifier: BSD-3-Clause
#include "examples/own_footsteps.h"

#include <fmt/format.h>

#include <cmath>

#include "planning/paths/standing_feet.h"

namespace gaitwright::examples {

std::vector<PlacedStep> StepsOnArc(const RobotModel& model, double radius_m, double turn_rad, double stride_m) {
  const double strides = radius_m * std::abs(turn_rad) / stride_m;
  if (!(radius_m > 0.0 && stride_m > 0.0 && strides > 0.0 && strides < 1000.0))
    throw InvalidArgument(
        fmt::format("stride_m {}, turn_rad {}, radius_m {}: stride and radius must be more than 0, the turn not 0, and "
                    "the arc shorter than 1000 strides",
                    stride_m, turn_rad, radius_m));
  const std::vector<Pose> standing = StandingFeet(model);
  const int feet = static_cast<int>(model.legs.size()), rounds = static_cast<int>(std::ceil(strides));
  const double to_left_m = std::copysign(radius_m, turn_rad);  // y of the centre of the arc
  std::vector<PlacedStep> steps;
  for (int round = 1; round <= rounds; ++round) {
    const double yaw = turn_rad * round / rounds;
    const PlanarPose body{to_left_m * std::sin(yaw), to_left_m * (1.0 - std::cos(yaw)), yaw};
    for (const int side : {1, 0}) {  // order of legs: front before rear, left before right
      for (int foot = feet - 2 + side; foot >= 0; foot -= 2) {
        const Vector3 p_WF = Carried(body, standing[static_cast<std::size_t>(foot)]).translation();
        steps.push_back({foot, {p_WF.x(), p_WF.y(), yaw}});
      }
    }
  }
  return steps;
}

}  // namespace gaitwright::examples
