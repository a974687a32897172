// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// The upright plane in which a leg bends, at joint positions zero, in the base frame O.
struct LegPlane {
  std::vector<int> joints;               ///< joints about its normal, base first; empty if no axis is level
  Vector3 normal_O = Vector3::UnitY();   ///< level, unit; to the left, or forward if the normal is along x
  Vector3 outward_O = Vector3::UnitX();  ///< level, unit, in the plane; where the leg points, else away from the base
  bool sprawls = false;  ///< an upright axis rotates the plane, and no level axis tilts it, like the coxa of an insect
  Vector3 p_OY = Vector3::Zero();  ///< a point on that upright axis; origin of the first joint if it does not sprawl
};

/// The plane of the largest group of a leg's revolute joints whose axes are level and parallel, both within 25 degrees.
/// Among groups of the same size, the one nearest to the base's y axis. Joints that rotate a foot without a sole about
/// its centre, like wheels, do not bend the leg and are left out.
LegPlane FindLegPlane(const RobotModel& model, const Leg& leg, const Foot& foot);

/// Largest distance from the origin of a leg's joint to its foot along the joints [m]: the sum of the distances between
/// joints and to `p_BF`, with every prismatic joint at the end of its stroke that reaches farther.
/// @param first  index into leg.joints.
/// @param p_BF  position of the foot in the last body.
double StraightLength(const RobotModel& model, const Leg& leg, std::size_t first, const Vector3& p_BF);

/// Sets the geometry of a leg: length_m, hip_joint, knee_joint, knee_sign.
void MeasureLeg(const RobotModel& model, Leg& leg, const Foot& foot);

/// Angle of the knee from straight at joint positions of the model, about the knee's axis [rad], in [-pi, pi].
double KneeBend(const RobotModel& model, const Leg& leg, const Foot& foot, const VectorX& joints);

}  // namespace gaitwright
