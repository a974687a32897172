// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <bit>
#include <vector>

#include "tests/playback/synthetic.h"

namespace gaitwright::synthetic {

/// Hops on the spot, after rest, with one group of feet after the other.
struct Hops {
  std::vector<FootSet> groups = {0b1001, 0b0110};
  int count = 8;
  double stance_s = 0.15, flight_s = 0.06;
  double rest_s = 0.5;
};

/// A constant force in each stance, none in flight. All feet push off for the first hop and land after the last one.
/// Feet in the air stay in place. For groups of feet, the middle is that of the hips.
MotionPlan HoppingPlan(const RobotModel& model, const Hops& hops = {});

}  // namespace gaitwright::synthetic
