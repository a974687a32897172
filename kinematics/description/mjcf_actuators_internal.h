// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "kinematics/description/mjcf_model_internal.h"

namespace gaitwright {

/// The combined effect of all actuators of a joint, at the joint.
struct MjcfDrive {
  int actuators = 0;
  bool is_bounded = true;            ///< each actuator has a force limit
  Vector3 effort = Vector3::Zero();  ///< largest effort by axis of a ball joint; x for another joint [N m, N]
  double stiffness = 0.0;            ///< gain on position [N m/rad, N/m]; 0 if there is none
  double damping = 0.0;              ///< gain on speed [N m s/rad, N s/m]; 0 if there is none
};

/// The drives by joint. The effort is |gear| times the largest force. `forcerange` limits this force, and so does
/// `ctrlrange` if the force is the control times a gain. Throws a Failure for unknown joints. Actuators of tendons,
/// slider-cranks, sites, bodies and joints that do not move are left out with a note.
std::vector<MjcfDrive> ReadMjcfDrives(MjcfContext& context, const MjcfTree& tree);

/// Effort of a joint whose motor has no known limit. The URDF then has a number so large that it counts as unknown.
inline constexpr double kMjcfUnknownEffort = std::numeric_limits<double>::infinity();

/// The effort limits by joint; 0 for a joint without a motor. Adds notes for joints without a limit or an actuator.
/// @param follows  by joint: whether it follows another joint and needs no actuator.
std::vector<double> MjcfEfforts(MjcfContext& context, const MjcfTree& tree, const std::vector<MjcfDrive>& drives,
                                const std::vector<bool>& follows);

}  // namespace gaitwright
