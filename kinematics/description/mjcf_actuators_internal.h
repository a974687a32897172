// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "kinematics/description/mjcf_model_internal.h"

namespace gaitwright {

/// What all actuators of a joint do together, at the joint.
struct MjcfDrive {
  int actuators = 0;
  bool is_bounded = true;            ///< each of them has a force limit
  Vector3 effort = Vector3::Zero();  ///< largest by axis of a ball joint; of another joint x [N m, N]
  double stiffness = 0.0;            ///< gain on position [N m/rad, N/m]; 0 without one
  double damping = 0.0;              ///< gain on speed [N m s/rad, N s/m]; 0 without one
};

/// The drives by joint. Effort is |gear| times the largest force, which `forcerange` bounds, and `ctrlrange` where
/// force is control times a gain. Throws a Failure on unknown joints; actuators of tendons and slider-cranks, and those
/// that act on sites, bodies and joints that do not move, are noted and left out.
std::vector<MjcfDrive> ReadMjcfDrives(MjcfContext& context, const MjcfTree& tree);

/// Effort of a joint of whose motor no limit is known. The URDF has a number so large that it is none.
inline constexpr double kMjcfUnknownEffort = std::numeric_limits<double>::infinity();

/// The effort limits by joint: 0 for a joint that has no motor. Joints without a limit and without an actuator are
/// noted. @param follows  by joint: it follows another one and needs no actuator.
std::vector<double> MjcfEfforts(MjcfContext& context, const MjcfTree& tree, const std::vector<MjcfDrive>& drives,
                                const std::vector<bool>& follows);

}  // namespace gaitwright
