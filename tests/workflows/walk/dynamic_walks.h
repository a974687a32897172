// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ostream>
#include <string>

#include "workflows/walk/walk.h"

namespace gaitwright {

/// A walk of the A1 on level ground, with a gait that has flight phases.
struct DynamicWalk {
  std::string gait;
  double speed_m_s = 0.0, distance_m = 0.0;
  double duty_factor = 0.0;  ///< 0 for the default of the gait
};

void PrintTo(const DynamicWalk& walk, std::ostream* out);

/// One forward jump of the A1.
WalkRequest OneLeap(const std::string& terrain, double length_m);

/// Plans the walk and plays it with the default controller. Expects flight phases, a passed audit and all gates passed.
void ExpectToFly(const DynamicWalk& walk);

/// As above for any command, for the A1 or another robot.
void ExpectToFly(const WalkRequest& request);
void ExpectToFly(const RobotModel& model, const WalkRequest& request);

}  // namespace gaitwright
