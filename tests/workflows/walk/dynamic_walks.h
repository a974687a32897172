// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ostream>
#include <string>

#include "workflows/walk/walk.h"

namespace gaitwright {

/// A walk of the A1 on level ground with a gait that leaves it.
struct DynamicWalk {
  std::string gait;
  double speed_m_s = 0.0, distance_m = 0.0;
  double duty_factor = 0.0;  ///< 0 for the gait's own
};

void PrintTo(const DynamicWalk& walk, std::ostream* out);

/// One jump ahead of the A1.
WalkRequest OneLeap(const std::string& terrain, double length_m);

/// Plans the walk and plays it with the controller that there is by default; expects flights, a plan that passes its
/// audit, and every gate to hold.
void ExpectToFly(const DynamicWalk& walk);

/// The same of any command, of the A1 or another robot.
void ExpectToFly(const WalkRequest& request);
void ExpectToFly(const RobotModel& model, const WalkRequest& request);

}  // namespace gaitwright
