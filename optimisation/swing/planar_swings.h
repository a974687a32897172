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

/// Tilts the swings of feet that move in a plane of the base with the base's lean at half time: with n the plane's
/// normal in W and e its horizontal part, the offset d of a swing from the straight line between its footholds becomes
///   d - (n.d / n.e) e, so a lifted foot moves sideways with its leg. Swings with a cruise phase are not changed.
/// @return the largest change of a swing, at half time [m].
double LeanSwings(const std::vector<std::optional<Vector3>>& planes_B, const BaseMotion& base,
                  std::vector<SwingTrajectory>& swings);

}  // namespace gaitwright
