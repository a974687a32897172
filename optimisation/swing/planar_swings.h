// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "kinematics/model/robot_model.h"
#include "optimisation/swing/former_motion.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// By leg: the normal, in the base frame B, of the plane in which its foot moves, if all joints of the leg rotate about
/// one direction or translate perpendicular to it. Nothing if the foot can leave such a plane, or if the plane is not
/// vertical.
std::vector<std::optional<Vector3>> PlanesOfLegs(const RobotModel& model);

/// Leans the swings of feet that stay in a plane of the base as the base leans at their half time: with n the plane's
/// normal in W and e its level part, what a swing is off the straight line between its footholds becomes
///   d - (n.d / n.e) e,
/// so that a foot that is lifted goes to the side as far as its leg takes it. Swings that cruise are left alone.
/// @return the largest change of a swing, at half time [m].
double LeanSwings(const std::vector<std::optional<Vector3>>& planes_B, const BaseMotion& base,
                  std::vector<SwingTrajectory>& swings);

}  // namespace gaitwright
