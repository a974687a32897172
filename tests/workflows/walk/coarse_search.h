// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/model/robot_model.h"
#include "workflows/walk/walk.h"

namespace gaitwright {

/// What an exhaustive search found.
struct CoarseAnswer {
  bool found = false;
  int states = 0;  ///< seen
};

/// Whether a coarse search of its own graph finds footholds from standing at the start to standing at the end of a
/// walk, by looking at all of them.
///
/// The base is at places of a lattice: along the way, a third of a stride apart, or for a goal in plan view around
/// start, goal and obstacles, a third of a leg apart and at 16 headings. Its feet stand where they belong there, or at
/// one of few places about that are nearest to it. The groups of the gait step in turn, each to a place next to that of
/// the group before it. Footholds and stances are those of FootholdChecker and StanceChecker, and steps no longer and
/// no higher than the options of the search say.
CoarseAnswer SearchCoarsely(const RobotModel& model, const Terrain& terrain, const WalkRequest& request);

}  // namespace gaitwright
