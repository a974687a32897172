// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// The upright plane in which a leg bends, at joint positions zero, in the base frame O.
struct LegPlane {
  std::vector<int> joints;               ///< that turn about its normal, base first; at least one unless none is level
  Vector3 normal_O = Vector3::UnitY();   ///< level, unit; to the left if that is known, else forward
  Vector3 outward_O = Vector3::UnitX();  ///< level, unit, in the plane; where the leg points, else away from the base
  bool sprawls = false;  ///< an upright axis swings the plane about and no level one tilts it, as an insect's coxa
  Vector3 p_OY = Vector3::Zero();  ///< on that upright axis; where the plane's first joint is when it does not sprawl
};

/// The largest group of a leg's revolute joints whose axes are level and parallel, within 25 degrees both; of equal
/// groups the one nearest to the base's y axis. Joints that rotate a foot without a sole about its centre, like wheels,
/// do not bend the leg and are left out.
LegPlane FindLegPlane(const RobotModel& model, const Leg& leg, const Foot& foot);

/// Longest distance from the origin of a leg's joint to the origin of its last body [m]: the sum of the distances
/// between joints, with every prismatic joint at the end of its stroke that reaches farther. A prismatic last joint
/// includes `p_BF`, the foot in its last body.
/// @param first index into leg.joints.
double StraightLength(const RobotModel& model, const Leg& leg, std::size_t first, const Vector3& p_BF);

/// Fills the geometry of a leg: length_m, hip_joint, knee_joint, knee_sign.
void MeasureLeg(const RobotModel& model, Leg& leg, const Foot& foot);

/// How far the knee is bent from straight at joint positions of the model, about its own axis [rad], in [-pi, pi].
double KneeBend(const RobotModel& model, const Leg& leg, const Foot& foot, const VectorX& joints);

}  // namespace gaitwright
