// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "kinematics/model/derive_legs.h"
#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// Distance from a body's joint to the farthest point of its collision shapes and frames [m].
double FarthestExtent(const RobotModel& model, int body);

/// The foot at the end of a leg. The axes of X_BF are those of the base at joint positions zero. For a sole that is
/// tilted at zero, they are those of the base in the posture where the sole is level; the axes of a sphere are set with
/// the posture.
/// @param biped     the robot has two legs, so legs of four joints may have soles too.
/// @param choices   contain the give of soles, unless `given` contains it.
/// @param given     the user's data of this foot, or null.
/// @param standing  joint positions by coordinate in which a tilted sole is level; NaN if not given.
Foot FindFoot(const RobotModel& model, const Leg& leg, const LegChoices& choices, const FootOverride* given,
              const VectorX& standing, bool biped = false);

/// A support surface for lying that is not a foot: the flat bottom of a link's shapes in the standing posture, with
/// `give_m` as in FindFlatBottom. Nothing if the link has no flat bottom. @throws InvalidArgument for an unknown link.
std::optional<Foot> FindRest(const RobotModel& model, const std::string& link, std::optional<double> give_m = {});

}  // namespace gaitwright
