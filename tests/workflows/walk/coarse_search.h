// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/model/robot_model.h"
#include "workflows/walk/walk.h"

namespace gaitwright {

/// Result of an exhaustive search.
struct CoarseAnswer {
  bool found = false;
  int states = 0;  ///< number of visited states
};

/// Exhaustive search of a separate coarse graph for footholds from standing at the start to standing at the end of a
/// walk.
///
/// The base is at places of a lattice: along the path, a third of a stride apart; or for a goal in plan view, around
/// start, goal and obstacles, a third of a leg apart and at 16 headings. Feet stand at their nominal positions or at
/// one of a few nearest positions. The groups of the gait step in turn, each to a place next to that of the previous
/// group. Footholds and stances must pass FootholdChecker and StanceChecker, and steps must be within the limits of the
/// search options.
CoarseAnswer SearchCoarsely(const RobotModel& model, const Terrain& terrain, const WalkRequest& request);

}  // namespace gaitwright
