// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "workflows/exchange/even_motion.h"

namespace gaitwright {

/// A joint that is held still, because dry friction takes most of what its motor has.
struct HeldJoint {
  int dof = 0;
  double moved = 0.0;                  ///< largest distance of the motion from where it is held [rad], [m]
  double friction = 0.0, limit = 0.0;  ///< [N m], [N]
};

/// Holds joints at the median of their positions over a motion if dry friction takes nearly all of what their motors
/// have, or most of it and they hardly move: grippers whose positions are noise. Changes positions alone.
std::vector<HeldJoint> HoldStuckJoints(const RobotModel& model, EvenMotion& motion);

}  // namespace gaitwright
