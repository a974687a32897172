// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/model/robot_model.h"
#include "planning/plan/terrain.h"
#include "workflows/repair/found_contacts_internal.h"

namespace gaitwright {

/// A stance with the pose on which its foot is pinned, as if spheres did not roll.
struct PinnedPlace {
  RowRange rows;  ///< the last one is that of lift-off
  Pose X_WF = Pose::Identity();
  double parted_m = 0.0;  ///< by how much PartFeet moved it
};

/// Moves stances horizontally, so that the feet of stances at the same time are a distance apart: feet of motions that
/// were made for another body often stand inside each other. Both feet move by half of what is lacking. Feet that
/// CollisionChecker does not check against each other may touch.
/// @param stances  by foot of a leg. @param least_m  the distance.
void PartFeet(const RobotModel& model, const Terrain& terrain, double least_m,
              std::vector<std::vector<PinnedPlace>>& stances);

}  // namespace gaitwright
