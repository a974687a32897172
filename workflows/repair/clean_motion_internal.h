// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "planning/plan/terrain.h"
#include "workflows/exchange/even_motion.h"
#include "workflows/repair/found_contacts_internal.h"
#include "workflows/repair/stuck_joints_internal.h"

namespace gaitwright {

/// A stance that was made clean.
struct PinnedStance {
  int foot = 0;
  double start_s = 0.0, end_s = 0.0;
  double slid_m = 0.0;    ///< largest horizontal distance of the foot from where it is pinned
  double height_m = 0.0;  ///< median height of its lowest point over the ground
  double tilt_rad = 0.0;  ///< largest tilt of its sole
  double parted_m = 0.0;  ///< moved, because it stood in another foot or too near to it
};

/// A motion whose feet stand still on the ground.
struct CleanMotion {
  EvenMotion motion;  ///< with contacts
  std::vector<PinnedStance> stances;
  std::vector<double> shift_m;  ///< by row: distance of the base from the file's
  double lift_m = 0.0;          ///< median of what was added to the base's height
  double unreached_m = 0.0;     ///< largest distance of a foot from where it should be, because of the legs' reach
  double unreached_s = 0.0;
  std::vector<HeldJoint> held;  ///< by HoldStuckJoints
};

/// Makes the contacts of a motion clean. Each stance is pinned to the mean of the foot's positions and headings over
/// it, with the sole flat on the ground, and feet that stand inside each other are moved apart (PartFeet). The base
/// moves by the mean of what its standing feet move by, smoothed over time. Swings begin and end on the pinned places
/// and keep a clearance. Joints follow by inverse kinematics that moves base and joints as little as possible, within
/// the joints' ranges.
/// @throws InvalidArgument if a foot stands where there is no ground.
CleanMotion CleanContacts(const RobotModel& model, const Terrain& terrain, const EvenMotion& motion,
                          const std::vector<FootSet>& stance, const RepairOptions& options);

}  // namespace gaitwright
